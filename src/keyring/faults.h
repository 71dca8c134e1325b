// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::keyring::fault {

using namespace mapwright::fault;  // what all rooms share

inline constexpr FaultCode NoKeyRing{"keyring",
                                     QT_TRANSLATE_NOOP("keyring", "there is no key ring on this computer")};
inline constexpr FaultCode KeyRingDenied{"keyring",
                                         QT_TRANSLATE_NOOP("keyring", "the key ring stays locked")};
/// its words
inline constexpr FaultCode KeyRingFailed{"keyring",
                                         QT_TRANSLATE_NOOP("keyring", "the key ring answered: %1")};
inline constexpr FaultCode KeyRingSilent{"keyring",
                                         QT_TRANSLATE_NOOP("keyring", "the key ring does not answer")};

}  // namespace mapwright::keyring::fault
