//! What a host computes for a span and for a frame: values that it is given, and statements that
//! make of them what a core is sent.
//!
//! The texts in `templates/methods` are such programs. A line is one of these, and goes on in lines
//! that begin with a blank:
//!
//! - `span vector NAME: ABOUT`, a value that the host has: of a span, a `frame` or a `material`; a
//!   `vector`, a `colour`, a `real` or a `whole` number; statements call it `span_NAME`;
//! - `vector NAME = EXPRESSION` or `real NAME = EXPRESSION`. Expressions are C's and Python's
//!   alike, and a function is `@NAME(...)`, which both libraries of functions have;
//! - `difference NAME = FROM, TO`, of two values of any of both kinds, each rounded for itself;
//! - what `macros` expands.
//!
//! What a port is given has its name, without `_x`, `_y` or `_z` where it is a vector.
use super::expression::{Token, tokens};
use super::macros;

/// The struct that a value of the host belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// That of a span.
    Span,
    /// That of a material.
    Material,
    /// That of a frame.
    Frame,
}

/// What a value of the host is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A vector in view space.
    Vector,
    /// Three numbers, for red, green and blue.
    Colour,
    /// A number.
    Real,
    /// A whole number, 0 or more.
    Whole,
    /// The span's pixels less one, which no struct has.
    Steps,
}

/// A value that a host has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The struct that has it.
    pub holder: Holder,
    /// What it is.
    pub kind: Kind,
    /// Its name in the struct.
    pub name: String,
    /// What it is, for people.
    pub about: String,
}

impl Source {
    /// Its name in statements.
    pub fn local(&self) -> String {
        match (self.holder, self.kind) {
            (_, Kind::Steps) => self.name.clone(),
            (Holder::Span, _) => format!("span_{}", self.name),
            (Holder::Material, _) => format!("material_{}", self.name),
            (Holder::Frame, _) => format!("frame_{}", self.name),
        }
    }
}

/// What a statement computes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Definition {
    /// A vector, by an expression.
    Vector(String),
    /// A number, by an expression.
    Real(String),
    /// The difference of two values, rounded for themselves: that of `to` less that of `from`.
    Difference { from: String, to: String },
}

/// A statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// The name of what it computes.
    pub name: String,
    /// How.
    pub definition: Definition,
}

/// Values and statements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    sources: Vec<Source>,
    statements: Vec<Statement>,
}

/// A number before it is rounded: one, or a component of a vector.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// The name of the value.
    pub name: String,
    /// The component, 0 to 2, of a vector.
    pub component: Option<usize>,
}

/// What an input of a core is given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Given {
    /// A number, rounded.
    Rounded(Number),
    /// The difference of two, each rounded.
    Difference {
        /// What is subtracted.
        from: Number,
        /// What it is subtracted from.
        to: Number,
    },
}

/// What some inputs depend on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// Values of the host.
    pub sources: Vec<Source>,
    /// Statements, each behind those that it depends on.
    pub statements: Vec<Statement>,
    /// What each of the inputs is given.
    pub given: Vec<Given>,
}

impl Program {
    /// Reads a program. None if it is not one, which no template is.
    pub fn parse(text: &str) -> Option<Program> {
        let steps = Source {
            holder: Holder::Span,
            kind: Kind::Steps,
            name: "steps".to_owned(),
            about: String::new(),
        };
        let mut program = Program { sources: vec![steps], statements: vec![] };
        for line in logical_lines(text) {
            program.add(&line)?;
        }
        Some(program)
    }

    fn add(&mut self, line: &str) -> Option<()> {
        let (word, rest) = line.split_once(' ')?;
        let holder = match word {
            "span" => Holder::Span,
            "material" => Holder::Material,
            "frame" => Holder::Frame,
            _ => return self.add_statement(word, rest),
        };
        let (kind, rest) = rest.split_once(' ')?;
        let (name, about) = rest.split_once(": ")?;
        let kind = match kind {
            "vector" => Kind::Vector,
            "colour" => Kind::Colour,
            "real" => Kind::Real,
            "whole" => Kind::Whole,
            _ => return None,
        };
        let (name, about) = (name.to_owned(), about.to_owned());
        self.sources.push(Source { holder, kind, name, about });
        Some(())
    }

    fn add_statement(&mut self, word: &str, rest: &str) -> Option<()> {
        let (name, expression) = rest.split_once(" = ")?;
        let definition = match word {
            "vector" => Definition::Vector(expression.to_owned()),
            "real" => Definition::Real(expression.to_owned()),
            "difference" => {
                let (from, to) = expression.split_once(", ")?;
                Definition::Difference { from: from.to_owned(), to: to.to_owned() }
            }
            _ => {
                let expanded = macros::expanded(word, name, expression)?;
                return expanded.lines().try_for_each(|line| self.add(line));
            }
        };
        self.statements.push(Statement { name: name.to_owned(), definition });
        Some(())
    }

    /// What inputs of these names depend on. None if one of them is not computed.
    pub fn part(&self, inputs: &[&str]) -> Option<Part> {
        let mut part = Part::default();
        for input in inputs {
            let given = self.given(input)?;
            match &given {
                Given::Rounded(number) => self.require(&number.name, &mut part)?,
                Given::Difference { from, to } => {
                    self.require(&from.name, &mut part)?;
                    self.require(&to.name, &mut part)?;
                }
            }
            part.given.push(given);
        }
        Some(part)
    }

    /// What the input of a name is given.
    fn given(&self, input: &str) -> Option<Given> {
        let axis = ["_x", "_y", "_z"].into_iter().position(|axis| input.ends_with(axis));
        let vector = axis.map(|axis| (&input[..input.len() - 2], axis));
        let (statement, component) = match (self.statement(input), vector) {
            (Some(statement), _) => (statement, None),
            (None, Some((name, axis))) => (self.statement(name)?, Some(axis)),
            (None, None) => return None,
        };
        let number = |name: &String| Number { name: self.resolved(name).to_owned(), component };
        Some(match &statement.definition {
            Definition::Vector(_) | Definition::Real(_) => Given::Rounded(number(&statement.name)),
            Definition::Difference { from, to } => {
                Given::Difference { from: number(from), to: number(to) }
            }
        })
    }

    fn statement(&self, name: &str) -> Option<&Statement> {
        self.statements.iter().find(|statement| statement.name == name)
    }

    /// Adds a value to a part, with all that it depends on.
    fn require(&self, name: &str, part: &mut Part) -> Option<()> {
        if let Some(source) = self.sources.iter().find(|source| source.local() == name) {
            if !part.sources.contains(source) {
                part.sources.push(source.clone());
            }
            return Some(());
        }
        let statement = self.statement(name)?;
        if part.statements.iter().any(|earlier| earlier.name == statement.name) {
            return Some(());
        }
        let definition = match &statement.definition {
            Definition::Vector(text) => Definition::Vector(self.required(text, part)?),
            Definition::Real(text) => Definition::Real(self.required(text, part)?),
            Definition::Difference { .. } => return None,
        };
        part.statements.push(Statement { name: statement.name.clone(), definition });
        Some(())
    }

    /// An expression with names for what has several, all of which are added to a part.
    fn required(&self, expression: &str, part: &mut Part) -> Option<String> {
        let mut text = String::new();
        for token in tokens(expression) {
            match token {
                Token::Name(name) => {
                    let name = self.resolved(name);
                    self.require(name, part)?;
                    text.push_str(name);
                }
                Token::Function(name) => {
                    text.push('@');
                    text.push_str(name);
                }
                Token::Literal(other) | Token::Other(other) => text.push_str(other),
            }
        }
        Some(text)
    }

    /// The name of a value that may be nothing but another one.
    fn resolved<'s>(&'s self, name: &'s str) -> &'s str {
        let text = match self.statement(name).map(|statement| &statement.definition) {
            Some(Definition::Vector(text) | Definition::Real(text)) => text,
            _ => return name,
        };
        match tokens(text)[..] {
            [Token::Name(other)] => self.resolved(other),
            _ => name,
        }
    }
}

/// The lines of a text without comments; one that begins with a blank goes on with the one before.
fn logical_lines(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for line in text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty()) {
        match (line.starts_with(' '), lines.last_mut()) {
            (true, Some(before)) => {
                before.push(' ');
                before.push_str(line.trim());
            }
            _ => lines.push(line.to_owned()),
        }
    }
    lines
}
