//! The program as its users see it: what it prints, what it writes, and how it ends.
mod bench;
mod compare;
mod errors;
mod explore;
mod figure9;
mod generate;
mod help;
mod methods;
mod needs;
mod output;
mod page;
mod program;
mod reproduce;
mod run;
mod spec;
mod stress;
mod wave;
