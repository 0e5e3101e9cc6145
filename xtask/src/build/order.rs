//! Puts the functions of a wasm module into an order that packs better; nothing else in it changes.
//!
//! gzip looks 32 kB back. Functions that are alike, as those are that one generic function became, lie further apart in what
//! the compiler writes; side by side they take 4 % less.

use crate::Failure;
use std::collections::{HashMap, VecDeque};
use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{CodeSection, FunctionSection, Module};
use wasmparser::{CodeSectionReader, FunctionSectionReader, Parser, Payload, TypeRef};

/// Two functions are as much alike as they have stretches of this many bytes in common.
const STRETCH: usize = 6;
/// How far back likeness counts, bytes: what gzip sees, less what a function adds itself.
const WINDOW: usize = 30_000;
/// A stretch that more functions have than this tells nothing, and costs the most.
const COMMON: usize = 200;
/// Added to a function's length, so that the shortest do not come first for a few bytes.
const SHORT: usize = 30;

/// The module with its functions in such an order. The same module always becomes the same.
pub fn ordered(wasm: &[u8]) -> Result<Vec<u8>, Failure> {
    let failed = |error: &dyn std::fmt::Display| Failure::invalid("the wasm", format!("{error:#}"));
    let (mut imported, mut bodies) = (0, Vec::new());
    for payload in Parser::new(0).parse_all(wasm) {
        match payload.map_err(|error| failed(&error))? {
            Payload::ImportSection(section) => {
                for import in section.into_imports() {
                    let import = import.map_err(|error| failed(&error))?;
                    imported += u32::from(matches!(import.ty, TypeRef::Func(_) | TypeRef::FuncExact(_)));
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(body.as_bytes()),
            _ => {}
        }
    }
    let order = by_likeness(&bodies);
    let mut places = vec![0; order.len()];
    for (place, &function) in (imported..).zip(&order) {
        places[function] = place;
    }
    let mut module = Module::new();
    Reordered { imported, order, places }
        .parse_core_module(&mut module, Parser::new(0), wasm)
        .map_err(|error| failed(&error))?;
    Ok(module.finish())
}

/// Writes a module with its own functions in another order.
struct Reordered {
    /// How many functions come from outside; they keep their numbers.
    imported: u32,
    /// Which of the module's own functions comes first, second, ...
    order: Vec<usize>,
    /// The new number of each.
    places: Vec<u32>,
}

impl Reencode for Reordered {
    type Error = std::convert::Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, Error> {
        Ok(function.checked_sub(self.imported).map_or(function, |own| self.places[own as usize]))
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        section: FunctionSectionReader<'_>,
    ) -> Result<(), Error> {
        let kinds = section.into_iter().collect::<Result<Vec<_>, _>>()?;
        for &function in &self.order {
            functions.function(kinds[function]);
        }
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        section: CodeSectionReader<'_>,
    ) -> Result<(), Error> {
        let bodies = section.into_iter().collect::<Result<Vec<_>, _>>()?;
        for function in self.order.clone() {
            utils::parse_function_body(self, code, bodies[function].clone())?;
        }
        Ok(())
    }
}

/// Begins with the function that has most in common with any; then always the one follows that has most in common with what went before, for its length.
fn by_likeness(bodies: &[&[u8]]) -> Vec<usize> {
    let stretches = numbered(bodies);
    let many = stretches.iter().flatten().max().map_or(0, |&last| last + 1);
    let mut holders: Vec<Vec<usize>> = vec![Vec::new(); many];
    for (function, held) in stretches.iter().enumerate() {
        for &stretch in held {
            holders[stretch].push(function);
        }
    }
    // How often each is in sight, how many of its stretches each function finds there, and what is in sight.
    let mut seen = vec![0_usize; many];
    let mut found = vec![0_usize; bodies.len()];
    let mut sight: VecDeque<usize> = VecDeque::new();
    let mut length = 0;
    let mut left: Vec<usize> = (0..bodies.len()).collect();
    let mut order = Vec::with_capacity(left.len());
    while !left.is_empty() {
        // As fractions: common stretches over length.
        let worth = |function: usize| {
            let length = stretches[function].len();
            if order.is_empty() { (length, 1) } else { (found[function], length + SHORT) }
        };
        let better = |best: usize, next: usize| {
            let ((common, length), (more, longer)) = (worth(left[best]), worth(left[next]));
            if more * length > common * longer { next } else { best }
        };
        let best = (0..left.len()).reduce(better).unwrap_or_default();
        let function = left.remove(best);
        order.push(function);
        sight.push_back(function);
        length += bodies[function].len();
        for &stretch in &stretches[function] {
            seen[stretch] += 1;
            if seen[stretch] == 1 {
                holders[stretch].iter().for_each(|&holder| found[holder] += 1);
            }
        }
        while length > WINDOW && sight.len() > 1 {
            let Some(gone) = sight.pop_front() else { break };
            length -= bodies[gone].len();
            for &stretch in &stretches[gone] {
                seen[stretch] -= 1;
                if seen[stretch] == 0 {
                    holders[stretch].iter().for_each(|&holder| found[holder] -= 1);
                }
            }
        }
    }
    order
}

/// The stretches of each function, each once and by number; not those of one function alone, nor of very many.
fn numbered(bodies: &[&[u8]]) -> Vec<Vec<usize>> {
    let each: Vec<Vec<&[u8]>> = bodies
        .iter()
        .map(|body| {
            let mut held: Vec<_> = body.windows(STRETCH).collect();
            held.sort_unstable();
            held.dedup();
            held
        })
        .collect();
    let mut holders: HashMap<&[u8], usize> = HashMap::new();
    for &stretch in each.iter().flatten() {
        *holders.entry(stretch).or_default() += 1;
    }
    let mut numbers: HashMap<&[u8], usize> = HashMap::new();
    each.iter()
        .map(|held| {
            let telling = held.iter().filter(|&stretch| (2..=COMMON).contains(&holders[stretch]));
            telling
                .map(|&stretch| {
                    let next = numbers.len();
                    *numbers.entry(stretch).or_insert(next)
                })
                .collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{by_likeness, ordered};
    use wasm_encoder::{
        CodeSection, ConstExpr, ElementSection, Elements, EntityType, ExportKind, ExportSection, Function,
        FunctionSection, ImportSection, Module, RefType, TableSection, TableType, TypeSection,
    };
    use wasmparser::{ElementItems, Operator, Parser, Payload};

    /// A function that pushes and drops these numbers, and then calls another.
    fn body(numbers: impl IntoIterator<Item = i32>, callee: u32) -> Function {
        let mut function = Function::new([]);
        let mut code = function.instructions();
        for number in numbers {
            code.i32_const(number).drop();
        }
        code.call(callee).end();
        function
    }

    /// A module with one imported function and three of its own, of which the first and the last are alike.
    fn module() -> Vec<u8> {
        let mut types = TypeSection::new();
        types.ty().function([], []);
        let mut imports = ImportSection::new();
        imports.import("m", "f", EntityType::Function(0));
        let mut functions = FunctionSection::new();
        (0..3).for_each(|_| {
            functions.function(0);
        });
        let mut tables = TableSection::new();
        tables.table(TableType {
            element_type: RefType::FUNCREF,
            table64: false,
            minimum: 3,
            maximum: None,
            shared: false,
        });
        let mut exports = ExportSection::new();
        for (name, index) in [("first", 1), ("second", 2), ("third", 3)] {
            exports.export(name, ExportKind::Func, index);
        }
        let mut elements = ElementSection::new();
        elements.active(None, &ConstExpr::i32_const(0), Elements::Functions((&[3, 2, 1][..]).into()));
        let mut code = CodeSection::new();
        code.function(&body(1000..1100, 2)).function(&body(5000..5030, 0)).function(&body(1000..1090, 1));
        let mut module = Module::new();
        module.section(&types).section(&imports).section(&functions).section(&tables);
        module.section(&exports).section(&elements).section(&code);
        module.finish()
    }

    type Told = (String, i32, Option<i32>);

    /// Of each exported function: its first number, and which function it calls, by its first number, or none for the imported one.
    fn told(wasm: &[u8]) -> (Vec<Told>, Vec<i32>) {
        let (mut exports, mut bodies, mut table) = (Vec::new(), Vec::new(), Vec::new());
        for payload in Parser::new(0).parse_all(wasm) {
            match payload.unwrap() {
                Payload::ExportSection(section) => exports.extend(section.into_iter().map(Result::unwrap)),
                Payload::ElementSection(section) => {
                    for element in section {
                        let ElementItems::Functions(items) = element.unwrap().items else {
                            panic!("no functions")
                        };
                        table.extend(items.into_iter().map(Result::unwrap));
                    }
                }
                Payload::CodeSectionEntry(body) => {
                    let operators = body.get_operators_reader().unwrap().into_iter().map(Result::unwrap);
                    let (mut first, mut callee) = (None, None);
                    for operator in operators {
                        match operator {
                            Operator::I32Const { value } => first = first.or(Some(value)),
                            Operator::Call { function_index } => callee = Some(function_index),
                            _ => {}
                        }
                    }
                    bodies.push((first.unwrap(), callee.unwrap()));
                }
                _ => {}
            }
        }
        let first = |index: u32| index.checked_sub(1).map(|own| bodies[own as usize].0);
        let exports = exports.iter().map(|export| {
            let (number, callee) = bodies[export.index as usize - 1];
            (export.name.to_owned(), number, first(callee))
        });
        (exports.collect(), table.iter().map(|&index| first(index).unwrap()).collect())
    }

    #[test]
    fn what_is_exported_called_and_listed_is_the_same_in_another_order() {
        let before = module();
        let after = ordered(&before).unwrap();
        assert_ne!(before, after);
        assert_eq!(told(&before), told(&after));
        assert_eq!(after, ordered(&before).unwrap());
    }

    #[test]
    fn what_is_alike_is_side_by_side() {
        let text = |word: &str| word.repeat(9).into_bytes();
        let all = [text("abcdefghij"), text("0123456789"), text("abcdefghik"), text("0123456780")];
        let bodies: Vec<&[u8]> = all.iter().map(Vec::as_slice).collect();
        let order = by_likeness(&bodies);
        assert_eq!((order[0] % 2, order[2] % 2), (order[1] % 2, order[3] % 2));
    }

    #[test]
    fn what_is_no_module_is_told() {
        assert!(ordered(b"no wasm").is_err());
    }
}
