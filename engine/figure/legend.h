/// What the colours of a field mean, written on a picture of the scene that shows it.
#pragma once

#include <optional>
#include <string>

#include "engine/core/image.h"
#include "engine/figure/field_figure.h"

namespace trocar::figure {

/// The picture with a card in its upper right corner: the field's title, `owner` below it ("A exact, segment A"; empty:
/// none), and the colour bar or the classes. The same pixels for the same arguments. With `below_px` it lies that far
/// below the picture's upper edge, which then is where the next one may begin; nothing is drawn where there is no room
/// left. `letters_px` is the em size of its small letters; nothing: what suits the picture.
Image with_legend(const Image& picture, const learning::Field& field, const plot::Colouring& colouring,
                  const std::string& owner, double& below_px, std::optional<double> letters_px = {});
Image with_legend(const Image& picture, const learning::Field& field, const plot::Colouring& colouring,
                  const std::string& owner);

}  // namespace trocar::figure
