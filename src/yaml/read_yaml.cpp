#include "yaml/read_yaml.h"

#include <map>
#include <sstream>
#include <vector>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/parser.h>

namespace mapwright::yaml {
namespace {

using Code = Broken::Code;

Broken brokenAt(Code code, const YAML::Mark& mark, std::string detail = {}) {
  if (mark.is_null()) return {code, 0, 0, std::move(detail)};
  return {code, mark.line + 1, mark.column + 1, std::move(detail)};
}

/// Weighs a document while it is parsed. yaml-cpp offers no other way out of a parser than an exception.
class Scale final : public YAML::EventHandler {
 public:
  explicit Scale(const Limits& limits) : limits_(limits) {}

  const YAML::Mark& start() const { return start_; }
  const YAML::Mark& root() const { return root_; }
  bool isEmpty() const { return empty_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    start_ = root_ = mark;
    empty_ = true;
    nodes_ = 0;
    open_.clear();
    anchors_.clear();
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    empty_ &= open_.empty() && value.empty() && (tag.empty() || tag == "?");
    leaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    empty_ = false;
    const auto found = anchors_.find(anchor);
    // Still open, it would contain itself.
    if (found == anchors_.end()) throw brokenAt(Code::NotYaml, mark, "recursive alias");
    add(mark, found->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    enter(mark, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    enter(mark, anchor);
  }
  void OnSequenceEnd() override { leave(); }
  void OnMapEnd() override { leave(); }

 private:
  struct Open {
    YAML::anchor_t anchor = YAML::NullAnchor;
    std::size_t before = 0;  // nodes
  };
  void add(const YAML::Mark& mark, std::size_t nodes) {
    if (nodes_ == 0) root_ = mark;
    if (nodes > limits_.most_nodes - nodes_) throw brokenAt(Code::TooMuch, mark);
    nodes_ += nodes;
  }
  void leaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    add(mark, 1);
    if (anchor != YAML::NullAnchor) anchors_[anchor] = 1;
  }
  void enter(const YAML::Mark& mark, YAML::anchor_t anchor) {
    empty_ = false;
    if (open_.size() >= limits_.most_depth) throw brokenAt(Code::TooDeep, mark);
    open_.push_back({anchor, nodes_});
    add(mark, 1);
  }
  void leave() {
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.anchor != YAML::NullAnchor) anchors_[closed.anchor] = nodes_ - closed.before;
  }

  Limits limits_;
  YAML::Mark start_ = YAML::Mark::null_mark(), root_ = start_;
  bool empty_ = true;
  std::size_t nodes_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> anchors_;  // nodes that each stands for
};

}  // namespace

tl::expected<Document, Broken> readYaml(const std::string& text, const Limits& limits) {
  if (text.size() > limits.most_bytes)
    return tl::make_unexpected(brokenAt(Code::TooLong, YAML::Mark::null_mark()));
  Document document;
  try {
    std::istringstream in(text);
    YAML::Parser parser(in);
    Scale scale(limits);
    std::optional<YAML::Mark> last;
    while (parser.HandleNextDocument(scale)) {
      const YAML::Mark here = scale.start();
      // At a token that can begin nothing, yaml-cpp finds one empty document after another, without end.
      if (last && last->pos == here.pos)
        return tl::make_unexpected(brokenAt(Code::NotYaml, here, "unexpected characters"));
      if (last && !scale.isEmpty() && !document.next) document.next = scale.root();
      last = here;
    }
    document.root = YAML::Load(text);
  } catch (const Broken& broken) {
    return tl::make_unexpected(broken);
  } catch (const YAML::Exception& broken) {
    return tl::make_unexpected(brokenAt(Code::NotYaml, broken.mark, broken.msg));
  }
  return document;
}

}  // namespace mapwright::yaml
