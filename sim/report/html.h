// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace shading::report {

// Text as it can stand between tags and inside quoted attributes: & < > " ' become entities.
std::string EscapeHtml(std::string_view text);

// RFC 4648, with padding.
std::string Base64(std::string_view bytes);

// A picture inside the page: <img> with a data URI.
std::string PngImage(std::string_view png, std::string_view description);

// 3 significant digits, without trailing zeros after the point: 0.00123, 0.5, 12.3, 1230.
std::string Significant(double value);

// A link to the page of the project, or the text alone where there is none.
std::string Link(std::string_view target, std::string_view text);

}  // namespace shading::report
