#pragma once

#include <bslnav/pictures/PictureStyle.h>

/** The look of what recurs in reports: one thing has one style in every picture. */
namespace bslnav::style {

inline constexpr FillStyle kPerson{palette::kMagenta, 0.35, 1.5};
inline constexpr FillStyle kRobot{palette::kInk, 0.12, 2.0};
inline constexpr FillStyle kDangerZone{palette::kOrange, 0.0, 2.0};
inline constexpr FillStyle kFrontier{palette::kOrange, 0.8, 0.0};
inline constexpr FillStyle kMayWalk{palette::kMagenta, 0.9, 0.0};
inline constexpr LineStyle kBinding{palette::kRed, 2.0, true};
inline constexpr FillStyle kUnmapped{palette::kWall, 0.8, 1.0};
inline constexpr LineStyle kGlobalPath{palette::kFaintInk, 2.0, true};
inline constexpr LineStyle kChosen{palette::kRed, 3.5, false};
inline constexpr LineStyle kWalk{palette::kMagenta, 2.5, true};
inline constexpr LineStyle kTrigger{palette::kGreen, 2.0, true};

}  // namespace bslnav::style
