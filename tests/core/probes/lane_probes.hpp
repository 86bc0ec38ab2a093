// Probes of core/numeric: lane operations, what a packet says of its lanes, elementary functions.
#pragma once

#include "core/numeric/elementary.hpp"
#include "core/numeric/shuffle.hpp"
#include "tests/core/probes/probes.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R, class F>
void map(const float* a, float* out, int count, F f) {
    for (int k = 0; k < count; k += kWidth<R>) store(out + k, f(load<R>(a + k)));
}

template <class R, class F>
void map(const float* a, const float* b, float* out, int count, F f) {
    for (int k = 0; k < count; k += kWidth<R>) store(out + k, f(load<R>(a + k), load<R>(b + k)));
}

template <class R, class F>
void map_bits(const float* a, const float* b, float* out, int count, F f) {
    map<R>(a, b, out, count, [f](R x, R y) { return from_bits(f(to_bits(x), to_bits(y))); });
}

template <class R>
void probe_unary(probes::Unary op, const float* a, float* out, int count) {
    using probes::Unary;
    switch (op) {
        case Unary::negate: return map<R>(a, out, count, [](R x) { return -x; });
        case Unary::root: return map<R>(a, out, count, [](R x) { return sqrt(x); });
        case Unary::magnitude: return map<R>(a, out, count, [](R x) { return absolute(x); });
        case Unary::round_trip: return map<R>(a, out, count, [](R x) { return from_bits(to_bits(x)); });
        case Unary::shift_left_5: return map<R>(a, out, count, [](R x) { return from_bits(to_bits(x) << 5); });
        case Unary::shift_right_9: return map<R>(a, out, count, [](R x) { return from_bits(to_bits(x) >> 9); });
        case Unary::cap_at_one: return map<R>(a, out, count, [](R x) { return min(x, 1.0f); });
        case Unary::raise_to_one: return map<R>(a, out, count, [](R x) { return max(x, 1.0f); });
    }
}

template <class R>
void probe_binary_bits(probes::Binary op, const float* a, const float* b, float* out, int count) {
    using probes::Binary;
    using B = Bits<R>;
    switch (op) {
        case Binary::bits_add: return map_bits<R>(a, b, out, count, [](B x, B y) { return x + y; });
        case Binary::bits_subtract: return map_bits<R>(a, b, out, count, [](B x, B y) { return x - y; });
        case Binary::bits_multiply: return map_bits<R>(a, b, out, count, [](B x, B y) { return x * y; });
        case Binary::bits_and: return map_bits<R>(a, b, out, count, [](B x, B y) { return x & y; });
        case Binary::bits_or: return map_bits<R>(a, b, out, count, [](B x, B y) { return x | y; });
        default: return map_bits<R>(a, b, out, count, [](B x, B y) { return x ^ y; });
    }
}

template <class R>
void probe_binary(probes::Binary op, const float* a, const float* b, float* out, int count) {
    using probes::Binary;
    switch (op) {
        case Binary::add: return map<R>(a, b, out, count, [](R x, R y) { return x + y; });
        case Binary::subtract: return map<R>(a, b, out, count, [](R x, R y) { return x - y; });
        case Binary::multiply: return map<R>(a, b, out, count, [](R x, R y) { return x * y; });
        case Binary::divide: return map<R>(a, b, out, count, [](R x, R y) { return x / y; });
        case Binary::least: return map<R>(a, b, out, count, [](R x, R y) { return min(x, y); });
        case Binary::greatest: return map<R>(a, b, out, count, [](R x, R y) { return max(x, y); });
        case Binary::choose: return map<R>(a, b, out, count, [](R x, R y) { return select(x < y, y, x); });
        case Binary::choose_or_one: return map<R>(a, b, out, count, [](R x, R y) { return select(x < y, x, 1.0f); });
        case Binary::one_or_choose: return map<R>(a, b, out, count, [](R x, R y) { return select(x < y, 1.0f, y); });
        case Binary::with_sign_of: return map<R>(a, b, out, count, [](R x, R y) { return flip_sign(x, y); });
        default: return probe_binary_bits<R>(op, a, b, out, count);
    }
}

template <class R>
void probe_facts(const float* a, const float* b, probes::PacketFacts* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const R x = load<R>(a + k), y = load<R>(b + k);
        const Mask<R> less = x < y;
        const Mask<R> positive = x > R(0);
        *out++ = {bits_of(less),
                  bits_of(x > y),
                  bits_of(x <= y),
                  bits_of(x >= y),
                  bits_of(x == y),
                  bits_of(x != y),
                  bits_of(Mask<R>(less & positive)),
                  bits_of(Mask<R>(less | positive)),
                  bits_of(!Mask<R>(less | positive)),
                  bits_of(select(less, positive, Mask<R>(!positive))),
                  count_of(less),
                  any(less),
                  all(less),
                  none(less),
                  first_lane(x),
                  largest_lane(x)};
    }
}

template <class R>
void probe_elementary(probes::Elementary op, const float* a, float* out, int count) {
    using probes::Elementary;
    switch (op) {
        case Elementary::exp2_minus_one: return map<R>(a, out, count, [](R x) { return exp2_minus_one(x); });
        case Elementary::exp2: return map<R>(a, out, count, [](R x) { return exp2(x); });
        case Elementary::log2: return map<R>(a, out, count, [](R x) { return log2_of(x, R(0)); });
        case Elementary::log2_one_minus: return map<R>(a, out, count, [](R x) { return log2_one_minus(x); });
        case Elementary::sine: return map<R>(a, out, count, [](R x) { return sincos_turn(x).sine; });
        case Elementary::cosine: return map<R>(a, out, count, [](R x) { return sincos_turn(x).cosine; });
    }
}

template <class R>
void probe_log2_with_lost(const float* u, const float* lost, float* out, int count) {
    map<R>(u, lost, out, count, [](R x, R y) { return log2_of(x, y); });
}

template <class R>
void probe_power(const float* x, const float* n, float* out, int count) {
    map<R>(x, n, out, count, [](R a, R b) { return power_of_one_minus(a, b); });
}

template <class R>
constexpr probes::LaneProbes lane_probes() {
    return {&probe_unary<R>,      &probe_binary<R>,         &probe_facts<R>,
            &probe_elementary<R>, &probe_log2_with_lost<R>, &probe_power<R>};
}

}  // namespace zerkalo::inline ZERKALO_ISA
