// SPDX-License-Identifier: GPL-3.0-or-later
// The ids of certificates, structures and parts. A certificate is one elementary claim of a
// structure's proof, a Query; class Certificate is in event_queue.h.
#ifndef KINEX_CORE_ENGINE_CERTIFICATE_H
#define KINEX_CORE_ENGINE_CERTIFICATE_H

#include <cstdint>

#include "core/arithmetic/query.h"

namespace kinex {

using CertificateId = std::uint32_t;  // reused after a certificate is retracted
inline constexpr CertificateId kNoCertificate = 0xffffffffu;  // none
using StructureId = std::uint8_t;  // in the order in which structures were added
// A part of a structure (Kernel::add_part), numbered from 0; 0 for a structure without parts.
using PartId = std::uint8_t;

}  // namespace kinex

#endif
