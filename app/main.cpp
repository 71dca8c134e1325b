#include "app/command_line.h"

int main(int argc, char** argv) { return mapwright::app::commandLine(argc, argv); }
