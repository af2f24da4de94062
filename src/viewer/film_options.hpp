// Film options: the film, or the sequence of shapes, that a command line asks for.
#pragma once

#include "film_plan.hpp"
#include "options.hpp"

namespace drapeau {

/// Throws InputError if there can be no such film, or if options contradict each other.
FilmPlan film_plan(const Options& options);

/// The shapes that --obj asks for: one, or one a frame of its name's numbers. Throws InputError likewise.
FilmPlan shape_plan(const Options& options);

/// Writes them; gives the exit status. Needs no display.
int write_shapes(const Options& options);

}  // namespace drapeau
