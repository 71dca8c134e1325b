// Overlays as GeoJSON: one document, or base, mine and theirs with a zero byte between them.
#include <algorithm>

#include "overlays/overlay_check.h"
#include "overlays/overlay_document.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_paste.h"
#include "target.h"

namespace mapwright::fuzz::overlays {
namespace {

using namespace mapwright::overlays;

std::vector<std::string> partsOf(Input input) {
  std::vector<std::string> parts(1);
  for (const std::uint8_t byte : input) {
    if (byte == 0 && parts.size() < 3) {
      parts.emplace_back();
    } else {
      parts.back().push_back(char(byte));
    }
  }
  return parts;
}

void look(const OverlayDocument& document) {
  for (const Feature& feature : document.features()) {
    use(feature.id());
    use(feature.name());
    use(feature.shape());
    use(feature.type());
    use(feature.coordinates());
    use(partShapeOf(feature));
  }
}

void edit(OverlayDocument document) {
  document.add(Feature(std::string(R"({"type":"Feature","id":"q"})")));
  MUST(OverlayDocument::read(document.text()));
  document.setMember("x", "1");
  MUST(OverlayDocument::read(document.text()));
  for (int left = 20; left > 0 && !document.features().empty(); --left) {
    document.remove(document.features().size() / 2);
    MUST(OverlayDocument::read(document.text()));
  }
}

void read(Input input) {
  const auto texts = partsOf(input);
  std::vector<OverlayDocument> documents;
  for (const std::string& text : texts) {
    use(OverlayDocument::isCollection(text));
    use(pastedFeatures(text));
    auto document = OverlayDocument::read(text);
    if (!document) return;
    MUST(document->text() == text);
    look(*document);
    documents.push_back(std::move(*document));
  }
  if (documents[0].features().size() < 200) use(flawsOf(documents[0], CheckOptions{}));
  documents.resize(3, documents.back());
  use(changesBetween(documents[0], documents[1]));
  const std::string merged = merge(documents[0], documents[1], documents[2]).document.text();
  MUST(merged.empty() || OverlayDocument::read(merged));
  if (texts.size() == 1) MUST(merged == texts[0]);
  edit(documents[0]);
}

}  // namespace
}  // namespace mapwright::fuzz::overlays

MAPWRIGHT_FUZZ_TARGET(overlays)
