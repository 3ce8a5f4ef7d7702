#pragma once

#include <bslnav/pictures/ColourMap.h>

namespace bslnav {

/** How a line is drawn; widths are pixels of the saved picture. */
struct LineStyle {
  Colour colour{0, 114, 178};
  double width_px = 2.5;
  bool dashed = false;
};

/** How an area is drawn: filled with `opacity` (0 to 1), outlined in the full colour; widths in
 * pixels. */
struct FillStyle {
  Colour colour{230, 120, 0};
  double opacity = 0.25;
  double outline_px = 1.5;  ///< 0 for no outline
};

/** Points of interest; each has one shape and colour in every picture. */
enum class MarkerKind {
  Start,       ///< green ring
  Goal,        ///< blue target
  Contact,     ///< red cross
  Pedestrian,  ///< magenta disc
  BlindSpot,   ///< orange diamond
  Stop         ///< dark square: the robot stood here
};

/** Colours that go together, tell apart for the colour-blind, and keep one meaning over all
 * pictures. */
namespace palette {
inline constexpr Colour kWhite{255, 255, 255};
inline constexpr Colour kInk{38, 43, 51};          ///< text
inline constexpr Colour kFaintInk{98, 106, 117};   ///< secondary text
inline constexpr Colour kFrame{176, 182, 190};     ///< axes
inline constexpr Colour kGrid{231, 234, 238};      ///< grid lines
inline constexpr Colour kWall{70, 76, 86};         ///< occupied
inline constexpr Colour kUnknown{218, 221, 226};   ///< neither free nor occupied
inline constexpr Colour kRejected{190, 194, 200};  ///< what a planner did not admit
inline constexpr Colour kInscribed{132, 88, 178};
inline constexpr Colour kLethal{46, 20, 78};
inline constexpr Colour kBlue{0, 114, 178};
inline constexpr Colour kRed{204, 44, 44};
inline constexpr Colour kOrange{230, 120, 0};
inline constexpr Colour kGreen{0, 145, 105};
inline constexpr Colour kMagenta{196, 62, 140};
inline constexpr Colour kSky{70, 166, 220};
}  // namespace palette

}  // namespace bslnav
