#include "collision_forge/planner_test/report/page_file.h"

#include "collision_forge/planner_test/report/deflated_text.h"
#include "collision_forge/planner_test/report/page_parts.h"

namespace forge {

// Records are base64, one per line, so their text cannot close the enclosing element.

PageFile::PageFile(const std::string& path) : file_(path) {
  file_.stream() << kPageHead << "<script type=\"text/plain\" id=\"records\">\n";
}

std::size_t PageFile::add(const std::string& record) {
  file_.stream() << deflatedText(record) << '\n';
  return count_++;
}

void PageFile::commit(const std::string& index) {
  file_.stream() << "</script>\n<script type=\"text/plain\" id=\"index\">" << deflatedText(index)
                 << "</script>\n"
                 << kPageFoot;
  file_.commit();
}

}  // namespace forge
