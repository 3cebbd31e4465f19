//! Text to tree as on the control: one pass over the bytes, never an `Err`, never a panic.
//!
//! ```text
//! file   := [lead] '%' EOB { program } '%'        lead, and text after a '%' up to its EOB, is skipped
//! program:= [ ( O uint | '<' name '>' ) [comment] ] { block EOB }    a file may hold several programs
//! block  := [ '/' [digit] ] [ N uint ] ( macro | words )
//! macro  := var '=' expr
//!         | IF '[' cond ']' GOTO expr | IF '[' cond ']' THEN var '=' expr | GOTO expr
//!         | WHILE '[' cond ']' DO uint | DO uint | END uint
//! words  := { letter ( number | expr ) | '/' }    X#1+10 and X[#1+10] are the same; '/' before a letter skips the rest
//! var    := '#' ( uint | var | '[' expr ']' )
//! expr   := term { ( '+' | '-' | OR | XOR ) term }
//! term   := factor { ( '*' | '/' | AND | MOD ) factor }
//! factor := number | var | ( '+' | '-' ) factor | FUNCTION '[' expr ']' | '[' expr ']' | ATAN '[' expr ']' '/' '[' expr ']'
//! cond   := expr ( EQ | NE | GT | GE | LT | LE ) expr
//! ```
//!
//! The rows of a control state its forms among these, and further ones (`==`, `SIN30`, `#9100`). In a language with names for programs,
//! labels and codes, the blocks are those of `symbolic`.
//!
//! Spaces have no meaning; `( … )` up to the first `)` is a comment, allowed anywhere; EOB is a line end or `;`. Small letters are read as
//! capitals. A block that does not parse becomes [`Stmt::Bad`] and is reported once, at the place of the mistake, with the control's alarm
//! number. A known mistake comes with a fix (`mistakes`).

pub(super) mod expression;
pub(super) mod files;

mod calls;
mod failure;
mod file;
mod formula;
mod mistakes;
mod reader;
mod statement;
mod symbolic;
mod tables;
mod words;
