// Terminal: what a program says outside its window. Complaints are one line on standard error; results go to standard
// output, and a program whose results were not written does not end well.
#pragma once

#include <string_view>

namespace drapeau {

/// "drapeau: what is wrong" on standard error: one line that moves no cursor, whatever names the text holds.
void complain(std::string_view program, std::string_view text);

/// Waits until what was written to standard output is where it goes. Gives `status`, or complains and gives 2.
int finish_output(std::string_view program, int status);

}  // namespace drapeau
