//! The program as its users see it: what it prints, what it writes, and how it ends.
mod bench;
mod errors;
mod figure9;
mod generate;
mod help;
mod methods;
mod needs;
mod output;
mod program;
mod reproduce;
mod run;
mod stress;
mod wave;
