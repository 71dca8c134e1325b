// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::keyring::fault {

using namespace mapwright::fault;  // what all rooms share

inline constexpr FaultCode NoKeyRing{"keyring",
                                     QT_TRANSLATE_NOOP("keyring", "there is no key ring on this computer")};
inline constexpr FaultCode KeyRingDenied{"keyring",
                                         QT_TRANSLATE_NOOP("keyring", "the key ring stays locked")};

}  // namespace mapwright::keyring::fault
