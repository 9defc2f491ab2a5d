#pragma once

#include <string>

#include "api/codec/exports/plan_brief.hpp"

namespace floeplan::codec {

/// The same page as PDF in A4. A long table continues on further pages. Needs a font on the machine: DejaVu Sans, or any
/// other that fontconfig finds.
/// Errors   std::runtime_error when the drawing library fails
[[nodiscard]] std::string plan_brief_pdf(const planning::Plan& plan, const BriefPictures& pictures,
                                         const BriefNotes& notes);

}  // namespace floeplan::codec
