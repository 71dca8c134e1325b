#include "edit/document_events.h"

namespace mapwright::edit {

DocumentEvents::~DocumentEvents() = default;

}  // namespace mapwright::edit

#include "moc_document_events.cpp"
