// The list of methods: names in files and on command lines, compiled kernels and choices in the window follow it.
#pragma once

#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/implicit_euler.hpp"
#include "drapeau/methods/leapfrog.hpp"
#include "drapeau/methods/rk4.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"
#include "drapeau/methods/xpbd.hpp"

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace drapeau {
inline namespace DRAPEAU_ISA {

using Methods = std::tuple<ForwardEuler, SemiImplicitEuler, Leapfrog, Rk4, ImplicitEuler, Xpbd>;

}  // namespace DRAPEAU_ISA

/// A method by its place in the list.
enum class Method : int {};

inline namespace DRAPEAU_ISA {

inline constexpr std::size_t method_count = std::tuple_size_v<Methods>;

/// Calls visit(method) with an object of the type that `id` stands for.
template <class Visit>
constexpr decltype(auto) with_method(Method id, Visit&& visit) {
    return [&]<std::size_t... n>(std::index_sequence<n...>)->decltype(auto) {
        using Result = decltype(visit(std::tuple_element_t<0, Methods>{}));
        if constexpr (std::is_void_v<Result>) {
            ((static_cast<std::size_t>(id) == n ? visit(std::tuple_element_t<n, Methods>{}) : void()), ...);
        } else {
            Result result{};
            ((static_cast<std::size_t>(id) == n ? void(result = visit(std::tuple_element_t<n, Methods>{})) : void()),
             ...);
            return result;
        }
    }
    (std::make_index_sequence<method_count>());
}

template <class M>
constexpr Method find_method() {
    int found = -1;
    [&]<std::size_t... n>(std::index_sequence<n...>) {
        ((std::is_same_v<std::tuple_element_t<n, Methods>, M> ? void(found = static_cast<int>(n)) : void()), ...);
    }
    (std::make_index_sequence<method_count>());
    return static_cast<Method>(found);
}

/// The place of a method's type in the list.
template <class M>
inline constexpr Method method_id = find_method<M>();

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
