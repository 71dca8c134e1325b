// Answers to calls (rosbridge v2, "service_response"). Pure.
#pragma once

#include <memory>
#include <optional>

#include <QString>

#include "net/rosbridge/call_book.h"
#include "net/rosbridge/frame.h"

namespace mapwright::net::rosbridge {

/// An id as text, whatever the server made of it; nullopt: there is none.
std::optional<QString> idIn(const Field& id);

/// What the answer to a call says. Words in it are plain and bounded.
CallAnswer readAnswer(const std::shared_ptr<const Frame>& frame);

}  // namespace mapwright::net::rosbridge
