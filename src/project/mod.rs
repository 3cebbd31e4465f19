//! The one door: a project in, a run out. Page and command line use nothing else to compute.
