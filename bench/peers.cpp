#include "peers.hpp"

#include "error.hpp"

namespace drapeau::bench {

void run_peers() {
    throw InputError("no peer was compiled in: install libbullet-dev and configure again");
}

}  // namespace drapeau::bench
