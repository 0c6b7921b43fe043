// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm.h>

#include "model/tlm/register_file.h"

namespace shading {

// Whether the registers accept an access, before anything is transferred: an access is done as a
// whole or not at all. Whole aligned words, mapped and of the right direction, no byte enables, no
// streaming.
tlm::tlm_response_status CheckAccess(const tlm::tlm_generic_payload& payload,
                                     const RegisterFile& registers);

}  // namespace shading
