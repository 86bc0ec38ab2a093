// Scenes that nobody ships, against the reference tracer, and alike for every instruction set.
#include "tests/laws/odd_scenes.hpp"

#include "tests/laws/oracle.hpp"

namespace zerkalo::laws {
namespace {

TEST(OddScene, AgreesWithTheReferenceButForSilhouettes) {
    for (const OddScene& odd : odd_scenes()) expect_agreement(odd.name, odd.scene, odd.settings);
}

TEST(OddScene, GivesTheSameBytesForEveryInstructionSet) {
    for (const OddScene& odd : odd_scenes()) {
        const Image serial = render(odd.scene, odd.settings, Isa::scalar);
        for (const Isa isa : available_isas()) {
            EXPECT_EQ(render(odd.scene, odd.settings, isa).hash(), serial.hash()) << odd.name << ", " << name_of(isa);
        }
    }
}

TEST(OddScene, GivesTheSameBytesWithoutCulling) {
    for (const OddScene& odd : odd_scenes()) {
        Settings exact = odd.settings;
        exact.exact_plan = true;
        EXPECT_EQ(pixels_apart(render(odd.scene, odd.settings), render(odd.scene, exact)), 0) << odd.name;
    }
}

}  // namespace
}  // namespace zerkalo::laws
