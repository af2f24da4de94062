// Command line: what both programs do alike with the words they are given, on top of CLI11.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace drapeau {

/// Lets an option's value be a path as people give it (io/given_path.hpp).
void take_as_path(CLI::Option* option);

/// A whole number from `lowest` to `highest`, written in digits.
CLI::Validator whole_number(long long lowest, long long highest);

/// Adds --set KEY=VALUE, which may be given several times.
void add_assignments(CLI::App& app, std::vector<std::string>& assignments);

/// Reads the words into the app's options. Throws CLI::ParseError; an option given an empty value, "--film \"\"" or
/// "--film=", is at fault too: it would be the same as an option that is not given.
void parse(CLI::App& app, int count, char** words);

/// What is wrong, in one line, with the way to name a file that begins with a dash, if that is what it was.
std::string explained(const CLI::App& app, const CLI::ParseError& error);

}  // namespace drapeau
