// Folders of the program's own files, which no other user reads.
#pragma once

#include <string>

namespace mapwright::disk {

/// Makes the folder, with those above it that are missing; each that is made is for this user alone. False:
/// it is not there.
bool makePrivateFolder(const std::string& folder);

/// Takes all rights of others from a file or folder of this user, if there is one.
void makePrivate(const std::string& path);

}  // namespace mapwright::disk
