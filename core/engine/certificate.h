// SPDX-License-Identifier: GPL-3.0-or-later
// Certificate: (predicate, a few object ids), one elementary claim of a structure's proof.
#ifndef KINEX_CORE_ENGINE_CERTIFICATE_H
#define KINEX_CORE_ENGINE_CERTIFICATE_H

#include <cstdint>

#include "core/arithmetic/query.h"

namespace kinex {

using CertificateId = std::uint32_t;
inline constexpr CertificateId kNoCertificate = 0xffffffffu;
using StructureId = std::uint8_t;
// A part of a structure (Kernel::add_part), from 0.
using PartId = std::uint8_t;

}  // namespace kinex

#endif
