// The law that every span obeys: it lies between the spans of the solid shrunk and grown by a few roundings.
#pragma once

#include "tests/core/support/exact_shapes.hpp"
#include "tests/core/support/rays.hpp"

#include <gtest/gtest.h>

namespace zerkalo::test {

struct Outcome {
    std::size_t hits = 0, misses = 0;
};

/// `span_of(k, grow)`: the exact span of ray k; `slack(k)`: by how much the surface may seem to move, scene units.
template <class SpanOf, class Slack>
void expect_nested(const RayList& rays, const SpanList& spans, SpanOf span_of, Slack slack, Outcome& outcome) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const Real80 room = slack(k);
        const ExactSpan least = span_of(k, -room), most = span_of(k, room);
        const Real80 entry = spans.entry[k], exit = spans.exit[k];
        const bool empty = !(entry < exit);
        if (!least.empty()) {
            ++outcome.hits;
            ASSERT_FALSE(empty) << text(rays, k) << " loses a chord of " << double(least.length());
            ASSERT_LE(entry, least.entry + room) << text(rays, k) << " enters too late";
            ASSERT_GE(exit, least.exit - room) << text(rays, k) << " leaves too early";
        }
        outcome.misses += most.empty();
        if (empty) continue;
        ASSERT_FALSE(most.empty()) << text(rays, k) << " meets what it should miss";
        ASSERT_GE(entry, most.entry - room) << text(rays, k) << " enters too early";
        ASSERT_LE(exit, most.exit + room) << text(rays, k) << " leaves too late";
    }
}

}  // namespace zerkalo::test
