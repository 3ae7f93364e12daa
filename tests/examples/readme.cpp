// placeholder until the README's program is here
int main() { return 0; }
