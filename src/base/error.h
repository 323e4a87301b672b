// The one exception that Tarn throws at its public faces: a message that a person can act on.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace tarn {

/// What went wrong, where (file and line where there is one) and what to do, in one line.
/// The program prints it after "tarn: error: " and exits with 1.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}

    template <typename... Args>
    explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(fmt::format(format, std::forward<Args>(args)...))
    {}
};

/// The command line, an option's name or its value is wrong: printed the same way, exit status 2.
class UsageError : public Error {
public:
    using Error::Error;
};

} // namespace tarn
