// crash_sentence.hpp -- what a user reads when a library crashes: a sentence instead of nothing.
#pragma once

namespace momentscope {

/// From now on a crash ends the program with this sentence and exit code 1; with nullptr it does what it does
/// otherwise. Returns what would have been said before. With AddressSanitizer, which tells more, nothing
/// changes.
const char* say_on_crash(const char* sentence);

/// The same while it lives.
class CrashSentence {
public:
    explicit CrashSentence(const char* sentence) : before_(say_on_crash(sentence)) {}
    ~CrashSentence() { say_on_crash(before_); }
    CrashSentence(const CrashSentence&) = delete;
    CrashSentence& operator=(const CrashSentence&) = delete;

private:
    const char* before_;
};

}  // namespace momentscope
