// A SystemC library exports the version of its interface by the C++ standard that it was built with. Whoever
// includes its modules gets a sentence, where another standard would end in a linker's error.
#pragma once

#if __cplusplus != 201703L
#error \
    "pineda::timing: expected C++17, which pineda and its SystemC library were built with (-std=c++17)"
#endif
