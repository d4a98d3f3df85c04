//! Tables for the terminal: aligned columns, no lines.

use comfy_table::presets::NOTHING;
use comfy_table::{Cell, CellAlignment, Table};

/// An empty table with the headings.
pub(super) fn plain(header: Vec<String>) -> Table {
    let mut table = Table::new();
    table.load_style(NOTHING).set_header(header.into_iter().map(Cell::new));
    table
}

/// Numbers are easier to read with their units in one column.
pub(super) fn right_aligned(table: &mut Table, column: usize) {
    if let Some(column) = table.column_mut(column) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}
