// Sanitized: whether a sanitizer watches these tests, under which a step takes ten to a hundred times as long. Where
// many scenes are tried only some are then: what a sanitizer looks for lies in the code, not in the scene.
#pragma once

namespace drapeau::testing {

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace drapeau::testing
