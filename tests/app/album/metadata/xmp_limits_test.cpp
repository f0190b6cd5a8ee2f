// SPDX-License-Identifier: Apache-2.0
// How much a packet may hold, to the one; where rdf:RDF may stand; what becomes of the text around a property.
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <string>

namespace xmp_limits_test {

using namespace tp;

namespace {

const std::string foreign = "http://example.org/foreign/";

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    all.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i)
        all += text;
    return all;
}

std::string rdf(const std::string& descriptions) {
    return "<rdf:RDF xmlns:rdf='" + xmp::rdf_uri + "' xmlns:f='" + foreign + "' xmlns:dc='" + xmp::dc_uri +
           "'>" + descriptions + "</rdf:RDF>";
}

std::string description(const std::string& properties, const std::string& attributes = "") {
    return "<rdf:Description" + attributes + ">" + properties + "</rdf:Description>";
}

/// The end of a sentence; empty where it is read.
QString refusal(const std::string& text) {
    const auto packet = XmpPacket::from(text);
    return packet ? QString() : QString::fromStdString(packet.error());
}

std::string numbered(std::size_t count, const std::string& before, const std::string& behind) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i)
        all += before + std::to_string(i) + behind;
    return all;
}

const QString too_many = "it has more entries than any program writes.";

} // namespace

class XmpLimitsTest : public QObject {
    Q_OBJECT
private slots:
    /// rdf:RDF, the description and 98 in each other.
    void a_hundred_elements_in_each_other() {
        const auto nested = [](std::size_t depth) {
            return repeated("<f:a>", depth) + repeated("</f:a>", depth);
        };
        QCOMPARE(refusal(rdf(description(nested(98)))), QString());
        QCOMPARE(refusal(rdf(description(nested(99)))),
                 QString("it is nested more deeply than any program writes."));
        QCOMPARE(refusal(rdf(description(repeated(nested(97) + "<f:b/>", 3)) + description(nested(98)))),
                 QString());
        QVERIFY(!refusal(rdf(description(nested(50) + "<f:b/>" + nested(99)))).isEmpty());
    }

    void ten_thousand_properties() {
        constexpr std::size_t most = 10'000;
        const auto attributes = [](std::size_t count) { return numbered(count, " f:a", "=''"); };
        const auto elements = [](std::size_t count) { return numbered(count, "<f:e", "/>"); };
        QCOMPARE(refusal(rdf(description("", attributes(most)))), QString());
        QCOMPARE(refusal(rdf(description("", attributes(most + 1)))), too_many);
        QCOMPARE(refusal(rdf(description(elements(most)))), QString());
        QCOMPARE(refusal(rdf(description(elements(most + 1)))), too_many);
        QCOMPARE(refusal(rdf(description(elements(5'000), attributes(5'000)))), QString());
        QCOMPARE(refusal(rdf(description(elements(5'000)) + description(elements(5'001)))), too_many);
        QCOMPARE(refusal(rdf(description(elements(most)) + description("") + "<!-- and no more -->")),
                 QString());
    }

    /// Signs are counted before they are read: these stand in a comment.
    void a_million_signs_of_markup() {
        constexpr std::size_t most = 1'000'000, around = 5; // "<" and "="
        QCOMPARE(refusal(rdf(description("")) + "<!--" + std::string(most - around, '<') + "-->"), QString());
        QCOMPARE(refusal(rdf(description("")) + "<!--" + std::string(most - around + 1, '<') + "-->"),
                 too_many);
        QCOMPARE(refusal(rdf(description("")) + "<!--" + std::string(most - 3, '=') + "-->"), QString());
        QCOMPARE(refusal(rdf(description("")) + "<!--" + std::string(most - 2, '=') + "-->"), too_many);
    }

    /// Those that are compared with each other, and white space between them.
    void ten_thousand_in_a_list() {
        const auto list = [](const std::string& name, std::size_t count) {
            return rdf(description("<" + name + "><rdf:Bag>" + repeated("<rdf:li/>", count) + "</rdf:Bag></" +
                                   name + ">"));
        };
        const QString listed = "it lists more people, words or recordings than any photograph has.";
        QCOMPARE(refusal(list("dc:subject", 20'000)), QString());
        QCOMPARE(refusal(list("dc:subject", 20'001)), listed);
        QCOMPARE(refusal(list("f:subject", 20'001)), QString());
        QCOMPARE(refusal(rdf(description("<dc:subject>" + repeated("<rdf:Bag/>", 20'001) + "</dc:subject>"))),
                 listed);
    }

    void sixteen_megabytes() {
        const std::string text = rdf(description(""));
        QCOMPARE(refusal(text + std::string((16u << 20) - text.size(), ' ')), QString());
        QCOMPARE(refusal(text + std::string((16u << 20) - text.size() + 1, ' ')),
                 QString("it is larger than 16 MB."));
    }

    void what_is_wrong_is_said() {
        QCOMPARE(refusal("<rdf:RDF"), QString("it is not whole XML."));
        QCOMPARE(refusal("<a/>"), QString("it is not XMP."));
        QCOMPARE(refusal("<rdf:RDF/>"), QString("it is not XMP."));
        QCOMPARE(refusal("<rdf:RDF xmlns:rdf='http://example.org/'/>"), QString("it is not XMP."));
        QCOMPARE(refusal("<rdf:Rdf xmlns:rdf='" + xmp::rdf_uri + "'/>"), QString("it is not XMP."));
        QCOMPARE(refusal(rdf(description("", " f:p='\xFC'"))),
                 QString("its letters are in an encoding that XMP does not allow."));
    }

    /// At the top, or in one element or two, behind others.
    void where_rdf_may_stand() {
        const std::string inner = rdf(description("", " f:p='1'"));
        const auto says = [](const std::string& text) {
            const auto packet = XmpPacket::from(text);
            const auto value = packet ? packet->value({foreign, "p"}) : std::nullopt;
            return value ? value->text : "nothing";
        };
        QCOMPARE(says(inner), std::string("1"));
        QCOMPARE(says("<!-- a --><?b?><x><y/>" + inner + "</x>"), std::string("1"));
        QCOMPARE(says("<x xmlns:f='urn:other'><y xmlns:rdf='urn:other'><z/></y><y>" + inner + "</y></x>"),
                 std::string("1"));
        QCOMPARE(says("<x><y><z>" + inner + "</z></y></x>"), std::string("nothing"));
        const std::string outside = "<x xmlns:r='" + xmp::rdf_uri + "' xmlns:g='" + foreign +
                                    "'><y><r:RDF><r:Description g:p='2'/></r:RDF></y></x>";
        QCOMPARE(says(outside), std::string("2"));
    }

    void what_is_said_of_the_packet_itself_is_no_property() {
        const auto packet =
            XmpPacket::from(rdf("text<!-- c -->" + description("<f:p>1</f:p>text<unknown:q/>",
                                                               " rdf:about='' xml:lang='de' plain='1' "
                                                               "xmlns:g='urn:g' g:r='2' unknown:s='3'")));
        std::string names;
        for (const XmpName& name : packet->names())
            names += name.uri + name.name + " ";
        QCOMPARE(names, "urn:gr " + foreign + "p ");
    }

    void a_property_goes_with_its_indentation_and_comes_behind_the_others() {
        const auto packet_with = [](const std::string& properties) {
            return "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri + "\" xmlns:f=\"" + foreign +
                   "\"><rdf:Description f:a=\"1\">" + properties + "</rdf:Description></rdf:RDF>";
        };
        auto packet = XmpPacket::from(packet_with("\n <f:p>1</f:p>\n\t<f:q/>text<f:r/>\n "));
        packet->remove({foreign, "p"});
        QCOMPARE(packet->bytes(), packet_with("\n\t<f:q/>text<f:r/>\n "));
        packet->remove({foreign, "r"}); // a text is nobody's indentation
        QCOMPARE(packet->bytes(), packet_with("\n\t<f:q/>text\n "));
        packet->set({foreign, "q"}, XmpValue::of("2"));
        packet->set({foreign, "q"}, XmpValue::of("3"));
        QCOMPARE(packet->bytes(), packet_with("text\n \n   <f:q>3</f:q>"));
        QCOMPARE(packet->value({foreign, "q"})->text, std::string("3"));
        packet->remove({foreign, "none"});
        packet->set({foreign, "a"}, XmpValue::of("4")); // in place of the attribute
        QCOMPARE(packet->value({foreign, "a"})->text, std::string("4"));
        QVERIFY(packet->bytes().find("f:a=") == std::string::npos);
    }

    void a_packet_without_a_description_gets_one() {
        auto packet = XmpPacket::from("<r:RDF xmlns:r=\"" + xmp::rdf_uri + "\"><!-- c --></r:RDF>");
        packet->set({xmp::dc_uri, "source"}, XmpValue::of("here"));
        QCOMPARE(packet->bytes(), "<r:RDF xmlns:r=\"" + xmp::rdf_uri +
                                      "\"><!-- c --><r:Description r:about=\"\">\n   <dc:source xmlns:dc=\"" +
                                      xmp::dc_uri + "\">here</dc:source></r:Description></r:RDF>");
    }

    void the_declaration_says_what_is_written() {
        const std::string text = rdf(description(""));
        const auto packet = XmpPacket::from(
            "<?xml version='1.1' encoding='latin1' standalone='yes'?><?xpacket begin='' id='a'?>" + text);
        QVERIFY(packet->bytes().starts_with(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?><?xpacket begin='' id='a'?><rdf:RDF"));
        QVERIFY(XmpPacket::from(text)->bytes().starts_with("<rdf:RDF")); // none is added
    }
};

} // namespace xmp_limits_test

TP_TEST(xmp_limits_test, XmpLimitsTest, event_loop)
#include "xmp_limits_test.moc"
