// The operations of one instruction set's vector registers against one lane's. Only that instruction set may run it.
#include "tests/fixed/vector_laws.hpp"

#include "core/geometry/unit.hpp"
#include "core/geometry/unrounded.hpp"
#include "core/geometry/vector_algebra.hpp"
#include "core/numeric/vector_elementary.hpp"
#include "core/shapes/half_spaces.hpp"

#include <type_traits>

namespace zerkalo::inline ZERKALO_ISA {
namespace {

constexpr int kLanes = kVectorWidth;
using One = FixedNumbers<1>;
using Wide = FixedNumbers<kLanes, Vectors>;

template <class F>
using WideOf = Fixed<Vectors<typename F::Element, kLanes>, F::kFormat>;

struct Draw {
    std::uint64_t state;

    std::uint64_t bits() {
        state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = (state ^ state >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return z ^ z >> 31;
    }
    /// Of any size, often at an end of the format, at zero, or beside a power of two.
    template <class T>
    T raw(int spare, bool with_sign) {
        constexpr int kBits = std::numeric_limits<T>::digits;
        const int most = kBits - spare;
        const std::uint64_t end = (std::uint64_t{1} << most) - 1, kind = bits() % 8;
        std::uint64_t size = bits() & end >> bits() % static_cast<std::uint64_t>(most);
        if (kind == 0) size = 0;
        if (kind == 1) size = end;
        if (kind == 2) size = std::uint64_t{1} << bits() % static_cast<std::uint64_t>(most);
        if (kind == 3) size = (std::uint64_t{1} << bits() % static_cast<std::uint64_t>(most)) - 1;
        if (kind == 4) size = end - (bits() & 3);
        const auto x = static_cast<T>(size);
        return with_sign && bits() % 2 != 0 ? static_cast<T>(-x) : x;
    }
};

template <class A, class F>
bool same(const A& wide, const F& one, int k) {
    if constexpr (requires { wide.raw; }) {
        return lane_of(wide.raw, k) == one.raw;
    } else if constexpr (requires { wide.first; }) {
        return same(wide.first, one.first, k) && same(wide.second, one.second, k);
    } else if constexpr (requires { wide.unit; }) {
        return same(wide.unit, one.unit, k) && same(wide.length, one.length, k);
    } else if constexpr (requires { wide.x; }) {
        return same(wide.x, one.x, k) && same(wide.y, one.y, k) && same(wide.z, one.z, k);
    } else {
        return wide.lane(k) == (one != 0);
    }
}

template <class F>
struct Arguments {
    F lane[kLanes];
    WideOf<F> wide;

    Arguments(Draw& draw, int spare, bool with_sign) {
        for (int k = 0; k < kLanes; ++k) {
            lane[k].raw = draw.raw<typename F::Element>(spare, with_sign);
            set_lane(wide.raw, k, lane[k].raw);
        }
    }
};

/// `spare`: bits that the arguments leave free, so that answers fit that must.
template <class Operation, int spare, bool with_sign, class... F>
int differing(std::uint64_t seed, int rounds) {
    Draw draw{seed};
    int found = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto check = [&found](const Arguments<F>&... arguments) {
            const auto wide = Operation()(arguments.wide...);
            for (int k = 0; k < kLanes; ++k) found += !same(wide, Operation()(arguments.lane[k]...), k);
        };
        check(Arguments<F>(draw, spare, with_sign)...);
    }
    return found;
}

// Operations as types without state, one expression for all widths.
#define ZERKALO_OPERATION(name, expression, ...) \
    struct name {                                 \
        auto operator()(__VA_ARGS__) const { return expression; } \
    };
ZERKALO_OPERATION(Sum, a + b, auto a, auto b)
ZERKALO_OPERATION(Difference, a - b, auto a, auto b)
ZERKALO_OPERATION(FittingSum, fitting_sum(a, b), auto a, auto b)
ZERKALO_OPERATION(FittingDifference, fitting_difference(a, b), auto a, auto b)
ZERKALO_OPERATION(Negative, -a, auto a)
ZERKALO_OPERATION(Absolute, absolute(a), auto a)
ZERKALO_OPERATION(Product, a * b, auto a, auto b)
ZERKALO_OPERATION(TimesUniform, (a * One::Direction::from_raw(-0x2f0d1357)), auto a)
ZERKALO_OPERATION(Less, a < b, auto a, auto b)
ZERKALO_OPERATION(AtMost, a <= b, auto a, auto b)
ZERKALO_OPERATION(Equal, a == b, auto a, auto b)
ZERKALO_OPERATION(Unequal, a != b, auto a, auto b)
ZERKALO_OPERATION(Smaller, min(a, b), auto a, auto b)
ZERKALO_OPERATION(Larger, max(a, b), auto a, auto b)
ZERKALO_OPERATION(Chosen, select(a < b, c, a), auto a, auto b, auto c)
ZERKALO_OPERATION(FlippedSign, flip_sign(a, b), auto a, auto b)
ZERKALO_OPERATION(PlusWhere, plus_where(a < b, a, b), auto a, auto b)
ZERKALO_OPERATION(Threefold, times(a, 3), auto a)
ZERKALO_OPERATION(Ahead, ahead_of(a, b, c), auto a, auto b, auto c)
ZERKALO_OPERATION(Dot, dot(Vec3<decltype(a)>{a, b, c}, Vec3<decltype(d)>{d, e, f}), auto a, auto b, auto c, auto d,
                  auto e, auto f)
ZERKALO_OPERATION(DotOfWays, dot_of_ways(Vec3<decltype(a)>{a, b, c}, Vec3<decltype(a)>{c, a, b}), auto a, auto b,
                  auto c)
ZERKALO_OPERATION(Cross, cross(Vec3<decltype(a)>{a, b, c}, Vec3<decltype(d)>{d, e, f}), auto a, auto b, auto c, auto d,
                  auto e, auto f)
ZERKALO_OPERATION(Unit, unit_of(Vec3<decltype(a)>{a, b, c}), auto a, auto b, auto c)
ZERKALO_OPERATION(ShortUnit, unit_of(Vec3<decltype(a)>{a, a - a, a - a}), auto a)
ZERKALO_OPERATION(Power, power_of_one_minus(a, b), auto a, auto b)
#undef ZERKALO_OPERATION

/// The type of the quantity To in as many lanes as A has.
template <class To, class A>
using Like = std::conditional_t<kLanesOf<typename A::Representation> == 1, To, WideOf<To>>;
template <class To>
struct As {
    auto operator()(auto a) const { return as<Like<To, decltype(a)>>(a); }
};
template <class To>
struct Rounded {
    auto operator()(auto a) const { return rounded<Like<To, decltype(a)>>(a); }
};
template <class To>
struct RoundedProduct {
    auto operator()(auto a, auto b) const { return product<Like<To, decltype(a)>>(a, b); }
};
template <class To>
struct ShareProduct {
    auto operator()(auto a, auto b) const { return share_product<Like<To, decltype(a)>>(a, b); }
};
template <class To>
struct Quotient {
    auto operator()(auto a, auto b) const { return quotient<Like<To, decltype(a)>>(a, b); }
};
template <class To>
struct Quotients {
    auto operator()(auto a, auto b, auto c) const { return quotients<Like<To, decltype(a)>>(a, b, c); }
};
template <class To>
struct Root {
    auto operator()(auto a) const { return root<Like<To, decltype(a)>>(a); }
};

/// Slabs whose planes are so close that rounding decides which of them a ray meets first.
struct CloseSlabs {
    struct Slab {
        Vec3<One::Direction> n;
        One::Index index;
    };
    template <class L, class F>
    struct Answer {
        L x, y;
        F z;
    };
    template <class L, class D>
    auto operator()(L a, L b, D slope) const {
        using N = System<L>;
        // 0.95 to 1.45: planes one step apart are met as far apart, or at one rounded distance.
        const auto eighth = One::Direction::from_raw(1 << 27), middle = One::Direction::from_raw(0x4ccccccd);
        const D along = fitting_sum(as<D>(slope * eighth), middle);
        const Vec3<One::Direction> axis{One::Direction(1), One::Direction(0), One::Direction(0)};
        const Slab slabs[] = {{axis, One::Index(1)}, {axis, One::Index(2)}, {axis, One::Index(3)}};
        const auto step = One::Length::from_raw(1);
        const SlabOrigin<N> seen[] = {{a, b}, {fitting_sum(a, step), fitting_difference(b, step)}, {b, a}};
        const auto span = slabs_span<Faces::entry, N>(slabs, 3, Vec3<D>{along, D(0), D(0)},
                                                      [&](std::int32_t s) ZERKALO_INLINE_LAMBDA { return seen[s]; });
        // Of an empty one it depends on the neighbours where clipping ended.
        const auto met = span.entry <= span.exit;
        const auto face = select(met, span.face_in, Index<N>(0));
        return Answer<L, Index<N>>{select(met, span.entry, L(0)), select(met, span.exit, L(0)), face};
    }
};

using L = One::Length;
using D = One::Direction;
using A = One::Area;
using S = One::Square;
using M = One::Moment;
using W = One::Weight;
using Chord = Fixed<std::int64_t, 61>;

template <class Operation, class... F>
constexpr test::VectorLaw law(const char* name) { return {name, &differing<Operation, 0, true, F...>}; }
template <int spare, class Operation, class... F>
constexpr test::VectorLaw fitting(const char* name) { return {name, &differing<Operation, spare, true, F...>}; }
template <int spare, class Operation, class... F>
constexpr test::VectorLaw unsigned_law(const char* name) { return {name, &differing<Operation, spare, false, F...>}; }

constexpr test::VectorLaw kLaws[] = {
    law<Sum, L, L>("a + b of words"), law<Sum, A, A>("a + b of 64 bits"),
    law<Difference, L, L>("a - b of words"), law<Difference, A, A>("a - b of 64 bits"),
    fitting<1, FittingSum, L, L>("fitting sum of words"), fitting<1, FittingSum, A, A>("fitting sum of 64 bits"),
    fitting<1, FittingDifference, L, L>("fitting difference of words"),
    fitting<1, FittingDifference, A, A>("fitting difference of 64 bits"),
    law<Negative, L>("-a of words"), law<Negative, A>("-a of 64 bits"), law<Absolute, L>("|a|"),
    law<Product, L, D>("a b"), law<TimesUniform, L>("a b of a uniform b"),
    law<Less, L, L>("a < b of words"), law<Less, A, A>("a < b of 64 bits"), law<AtMost, A, A>("a <= b"),
    law<Equal, L, L>("a == b of words"), law<Equal, A, A>("a == b of 64 bits"), law<Unequal, A, A>("a != b"),
    law<Smaller, L, L>("min"), law<Larger, L, L>("max"), law<Smaller, A, A>("min of 64 bits"),
    law<Chosen, L, L, L>("select of words"), law<Chosen, A, A, A>("select of 64 bits"),
    law<FlippedSign, L, L>("flip_sign"), law<FlippedSign, A, A>("flip_sign of 64 bits"),
    unsigned_law<0, PlusWhere, A, A>("plus_where"), fitting<2, Threefold, L>("times"), law<Ahead, L, L, L>("ahead_of"),
    law<As<L>, A>("as<Length>(area)"), law<As<L>, M>("as<Length>(moment)"), law<As<D>, S>("as<Direction>(square)"),
    law<As<One::Radiance>, A>("as<Radiance>(light)"), law<As<One::Ratio>, S>("as<Ratio>(square)"),
    law<As<A>, S>("as<Area>(square)"), law<As<A>, M>("as<Area>(moment)"), law<As<A>, L>("as<Area>(length)"),
    law<As<L>, D>("as<Length>(direction)"), law<As<D>, L>("as<Direction>(length)"),
    fitting<6, Rounded<L>, A>("rounded<Length>(area)"), fitting<3, Rounded<L>, M>("rounded<Length>(moment)"),
    fitting<3, Rounded<D>, S>("rounded<Direction>(square)"),
    fitting<1, Rounded<One::Ratio>, S>("rounded<Ratio>(square)"),
    law<RoundedProduct<D>, L, One::Inverse>("product<Direction>(length, inverse)"),
    law<RoundedProduct<L>, One::Ratio, A>("product<Length>(ratio, area)"),
    law<RoundedProduct<A>, One::Ratio, A>("product<Area>(ratio, area)"),
    law<RoundedProduct<S>, L, One::Curvature>("product<Square>(length, curvature)"),
    law<RoundedProduct<L>, One::Curvature, A>("product<Length>(curvature, area)"),
    unsigned_law<0, ShareProduct<One::Exponent>, Chord, One::Exponent>("share_product"),
    law<Quotient<L>, L, D>("length / direction"), law<Quotient<D>, D, D>("direction / direction"),
    law<Quotient<L>, A, L>("area / length"), law<Quotient<L>, A, A>("area / area"),
    law<Quotient<L>, D, One::Curvature>("direction / curvature"),
    law<Quotient<One::Inverse>, D, L>("direction / length as inverse"),
    law<Quotients<L>, L, L, D>("two quotients by one divisor"),
    fitting<1, CloseSlabs, L, L, D>("the span of slabs"),
    law<Root<L>, A>("root"), law<Dot, L, L, L, L, L, L>("dot of ways of any size"),
    fitting<1, Dot, L, L, L, D, D, D>("dot with a direction"), fitting<1, DotOfWays, L, L, L>("dot_of_ways"),
    law<Cross, L, L, L, L, L, L>("cross"), law<Unit, L, L, L>("unit_of of words"), law<ShortUnit, L>("unit_of an axis"),
    law<Unit, One::View, One::View, One::View>("unit_of of 64 bits"),
    unsigned_law<3, Power, Chord, One::Exponent>("power_of_one_minus")};

}  // namespace
}  // namespace zerkalo::inline ZERKALO_ISA

namespace zerkalo::test {

extern const VectorLaws ZERKALO_LAWS;
constinit const VectorLaws ZERKALO_LAWS{kLaws, sizeof kLaws / sizeof kLaws[0]};

}  // namespace zerkalo::test
