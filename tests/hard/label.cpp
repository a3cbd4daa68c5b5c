// hard-label FILE...: writes the oracle's labels into files of rays.
#include "tests/hard/suite.h"

#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string text = yarte::hard::labelled(argv[i]);
        std::ofstream(argv[i]) << text;
        std::cout << argv[i] << '\n';
    }
}
