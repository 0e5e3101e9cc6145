//! Drawing of plain data on any plotters backend; knows no gears and no studies.

pub mod drawing;
