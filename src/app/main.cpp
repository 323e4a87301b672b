#include "app/program.h"

int main(int argc, char** argv) { return tarn::runProgram({argv + (argc > 0 ? 1 : 0), argv + argc}, tarn::runViewer); }
