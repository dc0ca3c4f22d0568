// crash_sentence.hpp -- prints a sentence when a library crashes, instead of nothing.
#pragma once

namespace momentscope {

/// From now on, a crash prints this sentence and ends the program with exit code 1; nullptr restores the
/// normal behaviour. Returns the previous sentence. With AddressSanitizer, which reports more, it has no
/// effect.
const char* say_on_crash(const char* sentence);

/// Sets the sentence during its lifetime.
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
