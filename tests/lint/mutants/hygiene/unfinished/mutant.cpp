// A mark of unfinished work.
// TODO: the rest
