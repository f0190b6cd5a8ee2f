// SPDX-License-Identifier: Apache-2.0
#include "app/explore/demonstration.hpp"
#include "app/explore/explore_window.hpp"
#include "app/preferences/preferences.hpp"
#include "app/scene/extra_features.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/guide/vibration.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/system_loudspeaker.hpp"
#include "audio/speech/spoken_voice.hpp"

#include <QCommandLineParser>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>

#include <cstdio>
#include <cstdlib>

namespace {

/// The photograph asked for, else the sample that the program carries; empty where there is neither.
QString photo_to_open(const QStringList& arguments, const QTemporaryDir& folder) {
    if (!arguments.isEmpty())
        return arguments.front();
    const QString copy = folder.filePath("sample portrait.jpg");
    return QFile::copy(":/samples/portrait.jpg", copy) ? copy : QString();
}

/// Takes the picture when the finger has arrived, and ends the program.
void take_picture(tp::Demonstration& demonstration, QQuickView& window, const QString& file) {
    QObject::connect(&demonstration, &tp::Demonstration::finished, &window, [&window, file] {
        const bool saved = window.grabWindow().save(file);
        if (!saved)
            std::fprintf(stderr, "The picture could not be written to %s.\n", qUtf8Printable(file));
        QCoreApplication::exit(saved ? 0 : 1);
    });
}

} // namespace

int main(int argc, char** argv) {
    QGuiApplication app(argc, argv);
    QCoreApplication::setApplicationName("touchphoto");
    QCoreApplication::setApplicationVersion(TOUCHPHOTO_VERSION);

    QCommandLineParser options;
    options.setApplicationDescription("Feel the face in a photograph.");
    options.addHelpOption();
    options.addVersionOption();
    options.addPositionalArgument("photo", "The photograph to open; without one, a sample portrait.",
                                  "[photo]");
    const QCommandLineOption voice_option("voice", "Whether the program speaks: on (default) or off.",
                                          "on|off", "on");
    const QCommandLineOption picture_option("screenshot", "Writes a picture of the page to <file> and ends.",
                                            "file");
    const QCommandLineOption with_option(
        "with", "Adds features to eyes, lips and outline: brows, nose, irises.", "list");
    options.addOptions({voice_option, with_option, picture_option});
    options.process(app);
    const QString voice_wish = options.value(voice_option);
    if (voice_wish != "on" && voice_wish != "off") {
        std::fprintf(stderr, "--voice is \"on\" or \"off\".\n");
        return 2;
    }

    const auto extras = tp::extra_features_named(options.value(with_option).toStdString());
    if (!extras) {
        std::fprintf(stderr, "%s\n", extras.error().c_str());
        return 2;
    }

    tp::SpokenVoice voice;
    tp::NotificationAnnouncer announcer;
    tp::SystemLoudspeaker earcon_output, guide_output;
    tp::NoVibration vibration;
    tp::EarconPlayer earcons(earcon_output);
    tp::SonifiedGuide guide(guide_output, vibration);
    tp::Preferences preferences;
    preferences.change([&](tp::Choices& choices) {
        choices.brows = extras->brows;
        choices.nose = extras->nose;
        choices.irises = extras->irises;
    });
    earcons.set_on(!options.isSet(picture_option));
    if (options.isSet(picture_option))
        preferences.change([](tp::Choices& choices) { choices.guide = tp::Choices::Guide::none; });
    const bool speaks = voice_wish == "on" && !options.isSet(picture_option);
    tp::Narrator narrator(voice, announcer, speaks ? tp::Narrator::By::voice : tp::Narrator::By::screen_reader);
    tp::ExploreSession session(narrator, earcons, guide, preferences);
    tp::ExploreWindow window(session, announcer);
    if (window.status() == QQuickView::Error)
        return 1; // Qt has said why
    if (!options.isSet(picture_option))
        window.fit_to_screen();
    window.show();

    QTemporaryDir folder;
    if (const QString photo = photo_to_open(options.positionalArguments(), folder); !photo.isEmpty())
        session.open_file(photo);
    std::optional<tp::Demonstration> demonstration;
    if (options.isSet(picture_option))
        take_picture(demonstration.emplace(session), window, options.value(picture_option));
    // A program that has sounded must not take the sound server's connection down behind main().
    const int code = QGuiApplication::exec();
    narrator.stop();
    guide.silence();
    folder.remove();
    std::fflush(nullptr);
    std::_Exit(code);
}
