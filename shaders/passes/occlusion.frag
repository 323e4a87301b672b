// Nothing is written; what passes the depth test is counted.
void main() {}
