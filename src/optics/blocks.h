// The uniform blocks of shaders/shared/blocks.glsl as C++ structs: tarn::blocks::FrameBlock and so on. Fill
// one and copy it into a buffer as it is.
//
// std140 puts vec3 and vec4 on multiples of 16 bytes and lets a float follow a vec3; C++ puts everything on
// multiples of 4. The two agree as long as the file keeps to its rule (vec3 + float pairs), which is asserted
// here; the gl tests ask the driver as well.
#pragma once

#include "base/math.h"

#include <cstddef>
#include <type_traits>

#include "generated/blocks_float.h"

namespace tarn::blocks {

template <typename Block>
inline constexpr bool
    isStd140 = sizeof(Block) % 16 == 0 && std::is_standard_layout_v<Block>&& std::is_trivially_copyable_v<Block>;

static_assert(sizeof(vec3) == 12 && alignof(vec4) <= 16 && sizeof(mat4) == 64);
static_assert(isStd140<WaveTerm> && sizeof(WaveTerm) == 32);
static_assert(isStd140<LightTerm> && sizeof(LightTerm) == 48);
static_assert(isStd140<FrameBlock> && isStd140<ViewBlock> && isStd140<WavesBlock>);

// Everything that std140 aligns to 16.
static_assert(offsetof(LightTerm, position) == 0 && offsetof(LightTerm, intensity) == 16);
static_assert(offsetof(LightTerm, direction) == 32);
static_assert(offsetof(FrameBlock, sunDirection) % 16 == 0);
static_assert(offsetof(FrameBlock, sunIrradiance) % 16 == 0);
static_assert(offsetof(FrameBlock, sunDirectionBelow) % 16 == 0);
static_assert(offsetof(FrameBlock, sunBelow) % 16 == 0);
static_assert(offsetof(FrameBlock, absorption) % 16 == 0);
static_assert(offsetof(FrameBlock, deepRadiance) % 16 == 0);
static_assert(offsetof(FrameBlock, skyBelow) % 16 == 0);
static_assert(offsetof(FrameBlock, waterRect) % 16 == 0);
static_assert(offsetof(FrameBlock, skyIrradiance) % 16 == 0);
static_assert(offsetof(FrameBlock, lights) % 16 == 0);
static_assert(sizeof(FrameBlock) == offsetof(FrameBlock, lights) + maxLights * sizeof(LightTerm));
static_assert(offsetof(ViewBlock, viewFromWorld) == 64 && offsetof(ViewBlock, worldFromClip) == 128);
static_assert(offsetof(ViewBlock, eye) == 192 && offsetof(ViewBlock, clipPlane) == 208);
static_assert(offsetof(ViewBlock, pixels) == 224 && sizeof(ViewBlock) == 240);
static_assert(isStd140<SunBlock> && sizeof(SunBlock) == 112);
static_assert(sizeof(WavesBlock) == maxWaves * sizeof(WaveTerm));

} // namespace tarn::blocks
