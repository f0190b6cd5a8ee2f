// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tp {

/// A shared library that is loaded when it is needed, and not at the program's start, and stays for as long
/// as the program runs. Its names are seen by nobody else.
class LoadedLibrary {
public:
    /// `file` is looked for where the system looks for libraries.
    explicit LoadedLibrary(const char* file);

    /// False where the library is not there, or has no such function.
    template <typename Function>
    bool find(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(address_of(name));
        return function != nullptr;
    }

private:
    void* address_of(const char* name) const;

    void* handle_;
};

/// `Functions` is a struct with TP_LIBRARY_FUNCTIONS in its body. None where one of them is missing.
template <typename Functions>
std::optional<Functions> load_functions(const char* file) {
    Functions functions;
    return functions.find_in(LoadedLibrary(file)) ? std::optional(functions) : std::nullopt;
}

/// Members that are called as a library's functions are, and are these. `list` is a macro that applies
/// another to each name.
#define TP_LIBRARY_FUNCTIONS(list)                                                                           \
    list(TP_LIBRARY_MEMBER) bool find_in(const ::tp::LoadedLibrary& library) {                               \
        return list(TP_LIBRARY_FIND) true;                                                                   \
    }
#define TP_LIBRARY_MEMBER(name) decltype(&::name) name = nullptr;
#define TP_LIBRARY_FIND(name) library.find(name, #name)&&

/// The file name of a library of the version for which this program was built, a number in a macro.
#define TP_LIBRARY_FILE(name, version) name ".so." TP_LIBRARY_TEXT(version)
#define TP_LIBRARY_TEXT(version) #version

} // namespace tp
