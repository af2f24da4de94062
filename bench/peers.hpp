// Peers: other programs' cloth flying the same flag, where their libraries were found when this was built.
#pragma once

namespace drapeau::bench {

/// Prints the comparison. Throws InputError if no peer was compiled in.
void run_peers();

}  // namespace drapeau::bench
