// A mutant.
