// A program that does nothing, of targets that only precompile headers for the tests' programs.
int main() {}
