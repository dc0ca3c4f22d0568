// last_words_test.cpp -- when the display goes away, the session is saved in the usual folder for such files.
#include "app/last_words.hpp"

#include <cstdlib>

#include "tests/gui/folder_fixture.hpp"
#include "ui/model/session.hpp"

namespace momentscope::test {
namespace {

// Sets an environment variable during its lifetime; nullptr removes the variable.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    void set(const char* value) const {
        if (value != nullptr)
            ::setenv(name_, value, 1);
        else
            ::unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> before_;
};

class LastWordsTest : public FolderTest {};

TEST_F(LastWordsTest, TheFolderIsTheOneForStateUnlessItIsRelative) {
    const Variable home("HOME", "/home/somebody");
    const fs::path in_home = "/home/somebody/.local/state/momentscope";
    {
        const Variable state("XDG_STATE_HOME", "/elsewhere");
        EXPECT_EQ(recovery_folders()[0], "/elsewhere/momentscope");
        EXPECT_EQ(recovery_folders()[1], in_home);
    }
    const Variable state("XDG_STATE_HOME", "relative");
    EXPECT_EQ(recovery_folders()[0], in_home);
}

TEST_F(LastWordsTest, EachSaveIsAFileOfItsOwnThatOpensAgain) {
    const std::string here = fs::current_path().string();
    const Variable state("XDG_STATE_HOME", here.c_str());
    ui::ExplorerState wanted;
    wanted.scene = "planes";
    wanted.lens = true;
    for (int i = 0; i < 3; ++i) {
        const std::string words = last_words(wanted);
        EXPECT_NE(words.find(here + "/momentscope/recovered-"), std::string::npos) << words;
    }
    int count = 0;
    for (const auto& entry : fs::directory_iterator("momentscope")) {
        ++count;
        EXPECT_EQ(ui::read_session_file(entry.path()).state, wanted);
    }
    EXPECT_EQ(count, 3);
}

TEST_F(LastWordsTest, WhereNothingCanBeWrittenItSaysSo) {
    const Variable state("XDG_STATE_HOME", "/dev/null");
    const Variable home("HOME", "/dev/null");
    const Variable temporary("TMPDIR", "/dev/null");
    EXPECT_NE(last_words({}).find("could not be saved"), std::string::npos);
}

}  // namespace
}  // namespace momentscope::test
