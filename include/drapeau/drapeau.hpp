// The whole core. To read it: field and state, term and model, spring, sweep, advance, one of methods/, one of terms/,
// stepper, flag.
#pragma once

#include "drapeau/fabric.hpp"
#include "drapeau/flag.hpp"
