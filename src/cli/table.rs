//! Tables for the terminal: aligned columns, no lines.

use anstyle::Style;
use comfy_table::presets::NOTHING;
use comfy_table::{Cell, CellAlignment, Table};

/// What stands above a table or a list.
pub(super) const HEADING: Style = Style::new().bold();

/// An empty table with the headings.
pub(super) fn plain(header: impl IntoIterator<Item = impl ToString>) -> Table {
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
