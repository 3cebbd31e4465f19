//! Mitsubishi MELDAS E60: rows only.
