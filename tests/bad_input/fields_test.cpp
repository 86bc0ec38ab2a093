// The table of fields is complete: every byte of a scene is a field of it, or stands between two for their alignment.
#include "tests/bad_input/fields.hpp"

#include "core/scene/validate.hpp"
#include "tests/bad_input/base_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <type_traits>

namespace zerkalo::bad_input {
namespace {

TEST(SceneFields, EveryByteOfASceneIsInTheTable) {
    static_assert(std::is_standard_layout_v<Scene> && std::is_trivially_copyable_v<Scene>);
    const auto scene = std::make_unique<Scene>();
    std::size_t end = 0;
    const auto aligned = [&end](std::size_t to) { return (end + to - 1) / to * to; };
    for (const Field& field : all_fields(*scene)) {
        // A part that begins with a choice is aligned as the doubles in it are.
        if (field.type != FieldType::choice || field.offset != aligned(alignof(double))) {
            ASSERT_EQ(field.offset, aligned(field.size))
                << text_of(field) << ": a member before it is not in the table";
        }
        end = field.offset + field.size;
    }
    EXPECT_EQ(aligned(alignof(Scene)), sizeof(Scene)) << "a member at the end is not in the table";
}

TEST(SceneFields, AllOfAScenesPartsAreInUseWhenItIsCrowded) {
    const Scene& scene = crowded_scene().scene;
    ASSERT_TRUE(validate(scene).ok()) << validate(scene).field << " " << validate(scene).reason;
    const std::vector<Field> fields = fields_in_use(scene);
    const auto count = [&fields](Part part) {
        return std::count_if(fields.begin(), fields.end(), [part](const Field& field) { return field.part == part; });
    };
    // Fields a part: of an image, a camera, a light, a solid, a mirror without corners, a corner, a triangle.
    constexpr int kImage = 2, kCamera = 11, kLight = 8, kSolid = 25, kMirror = 25, kCorner = 2, kTriangle = 9;
    EXPECT_EQ(count(Part::image), kImage);
    EXPECT_EQ(count(Part::camera), kCamera);
    EXPECT_EQ(count(Part::scene), 3 + 3 + 4);
    EXPECT_EQ(count(Part::light), 2 * kLight);
    EXPECT_EQ(count(Part::solid), 7 * kSolid + 4 * kTriangle);
    EXPECT_EQ(count(Part::mirror), 7 * kMirror + 2 * 4 * kCorner);
}

TEST(SceneFields, SetWritesOneFieldAndNoOther) {
    const auto scene = std::make_unique<Scene>();
    for (const Field& field : all_fields(*scene)) {
        if (field.name != "curvature_radius" || field.index != 1) continue;
        set(*scene, field, 7.0);
        EXPECT_EQ(scene->mirrors[1].curvature_radius, 7);
        EXPECT_EQ(scene->mirrors[0].curvature_radius, kInfinity);
        EXPECT_EQ(scene->mirrors[1].lobe_exponent, kInfinity);
        EXPECT_EQ(scene->mirrors[1].boundary.corners[kMaxCorners - 1].y, 0);
        return;
    }
    FAIL() << "no second mirror in the table";
}

}  // namespace
}  // namespace zerkalo::bad_input
