// Formatted by nobody.
int  f( ){return 1 ;}
