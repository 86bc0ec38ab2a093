// How far a picture is from another one, region by region; and what storing it in few bits adds.
#pragma once

#include "tools/study/regions.hpp"

namespace zerkalo::study {

/// Linear light, all three channels of a region's pixels pooled; nothing is clipped but for psnr. All 0 (psnr
/// infinite) for a region without pixels.
struct ErrorFigures {
    double rmse = 0;
    double max = 0;
    double p999 = 0;  // 99.9 % of the values are at most so far off
    double psnr = 0;  // dB, of the 16-bit sRGB codes; infinite for equal codes
};

/// Precondition: pictures of one size, one flag a pixel.
ErrorFigures error_figures(const LightPicture& a, const LightPicture& b, const Mask& mask);

/// Only the RMSE of error_figures().
double rmse_of(const LightPicture& a, const LightPicture& b, const Mask& mask);

/// The picture as sRGB codes of 8, 10 or 16 bits hold it, in linear light. 10-bit codes are 16-bit codes rounded.
LightPicture quantised(const LightPicture& picture, int bits);

/// The picture with its light clipped to 0..1: what codes can hold.
LightPicture clipped(LightPicture picture);

}  // namespace zerkalo::study
