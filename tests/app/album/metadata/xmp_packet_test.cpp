// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>

namespace xmp_packet_test {

using namespace tp;

namespace {

const std::string foreign = "http://example.org/foreign/";

std::string rdf(const std::string& description) {
    return "<rdf:RDF xmlns:rdf='" + xmp::rdf_uri + "' xmlns:f='" + foreign + "'>" + description +
           "</rdf:RDF>";
}

XmpPacket read(const std::string& text) {
    auto packet = XmpPacket::from(text);
    return packet ? std::move(*packet) : XmpPacket();
}

XmpValue value_in(const std::string& description) {
    return read(rdf(description)).value({foreign, "p"}).value_or(XmpValue::of("(none)"));
}

XmpValue structure(std::initializer_list<XmpField> fields) {
    XmpValue value;
    value.form = XmpValue::Form::structure;
    value.fields = fields;
    return value;
}

std::string utf16(std::u16string_view text, bool big) {
    std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t unit : text) {
        const char high = static_cast<char>(unit >> 8);
        const char low = static_cast<char>(unit & 0xFF);
        bytes += big ? high : low;
        bytes += big ? low : high;
    }
    return bytes;
}

} // namespace

class XmpPacketTest : public QObject {
    Q_OBJECT

private slots:
    void every_spelling_of_a_structure_is_one() {
        const XmpValue expected = structure({{{foreign, "a"}, XmpValue::of("1")}});
        for (const char* text :
             {"<rdf:Description><f:p rdf:parseType='Resource'><f:a>1</f:a></f:p></rdf:Description>",
              "<rdf:Description><f:p><rdf:Description><f:a>1</f:a></rdf:Description></f:p></rdf:Description>",
              "<rdf:Description><f:p><rdf:Description f:a='1'/></f:p></rdf:Description>",
              "<rdf:Description><f:p f:a='1'/></rdf:Description>",
              "<rdf:Description/><rdf:Description><f:p f:a='1'></f:p></rdf:Description>"})
            QVERIFY2(value_in(text) == expected, text);
    }

    void a_text_is_an_element_or_an_attribute() {
        for (const char* text :
             {"<rdf:Description f:p='a&amp;b'/>", "<rdf:Description><f:p>a&#38;b</f:p></rdf:Description>",
              "<rdf:Description><f:p><![CDATA[a&b]]></f:p></rdf:Description>",
              "<rdf:Description xmlns:g='http://example.org/foreign/' g:p='a&amp;b'/>"})
            QVERIFY2(value_in(text) == XmpValue::of("a&b"), text);
    }

    void qualifiers_stay_with_their_value() {
        XmpValue expected = XmpValue::of("1");
        expected.qualifiers = {{{foreign, "q"}, XmpValue::of("2")}};
        for (const char* text :
             {"<rdf:Description><f:p "
              "rdf:parseType='Resource'><rdf:value>1</rdf:value><f:q>2</f:q></f:p></rdf:Description>",
              "<rdf:Description><f:p rdf:value='1' f:q='2'/></rdf:Description>"})
            QVERIFY2(value_in(text) == expected, text);
    }

    void what_is_set_is_read_again_in_its_whole_depth() {
        XmpValue item = structure({{{foreign, "a"}, XmpValue::of("x\r\n\t<&>\"'")},
                                   {{"urn:other#", "a"}, XmpValue::of("")},
                                   {{xmp::dc_uri, "title"}, XmpValue::of("ü👩")}});
        item.qualifiers = {{{foreign, "q"}, XmpValue::of("2")}, {xmp::language, XmpValue::of("de")}};
        XmpValue link = XmpValue::of("http://example.org/?a=1&b=2");
        link.form = XmpValue::Form::link;
        XmpValue list;
        list.form = XmpValue::Form::seq;
        list.items = {item, XmpValue::of("plain"), link};
        XmpPacket packet;
        packet.set({foreign, "p"}, list);
        const auto again = read(packet.bytes()).value({foreign, "p"});
        QVERIFY(again.has_value());
        // the qualifiers' order is not part of the value
        XmpValue read_list = *again;
        std::swap(read_list.items.at(0).qualifiers.at(0), read_list.items.at(0).qualifiers.at(1));
        QVERIFY(*again == list || read_list == list);
    }

    void what_is_not_changed_comes_out_as_it_was() {
        const std::string text = "<?xpacket begin='\xEF\xBB\xBF'?>\n<!-- a -->" +
                                 rdf("<rdf:Description f:a='&#x41;  &apos;\n' f:p=\"1\"><f:b xml:lang='x'> "
                                     "a\r\n&#13;&unknown; </f:b>"
                                     "<!-- kept --><?kept too?><f:c><![CDATA[<&]]></f:c></rdf:Description>") +
                                 "\n   \n<?xpacket end='w'?>";
        XmpPacket packet = read(text);
        packet.set({foreign, "p"}, XmpValue::of("2"));
        const std::string bytes = packet.bytes();
        for (const char* piece :
             {"f:a=\"&#x41;  &apos;\n\"", "<f:b xml:lang=\"x\"> a\r\n&#13;&unknown; </f:b>",
              "<!-- kept --><?kept too?>", "<![CDATA[<&]]>", "<!-- a -->", "\n   \n<?xpacket end"})
            QVERIFY2(bytes.find(piece) != std::string::npos, bytes.c_str());
        QCOMPARE(read(bytes).value({foreign, "p"})->text, std::string("2"));
    }

    void quotation_marks_between_apostrophes_survive() {
        XmpPacket packet = read(rdf("<rdf:Description f:p='say \"hi\"'/>"));
        QCOMPARE(read(packet.bytes()).value({foreign, "p"})->text, std::string("say \"hi\""));
    }

    void a_prefix_that_means_something_else_is_not_used() {
        XmpPacket packet = read(rdf("<rdf:Description xmlns:dc='urn:not-dublin-core' dc:x='1'/>"));
        packet.set(xmp::keywords, XmpValue::of("a"));
        const XmpPacket again = read(packet.bytes());
        QCOMPARE(again.value(xmp::keywords)->text, std::string("a"));
        QCOMPARE(again.value({"urn:not-dublin-core", "x"})->text, std::string("1"));
    }

    void a_prefix_that_cannot_begin_a_name_is_not_used() {
        for (const std::string prefix : {"-f", "1e400", ".f"}) {
            XmpPacket packet = read("<rdf:RDF xmlns:rdf='" + xmp::rdf_uri +
                                    "'><rdf:Description xmlns:" + prefix + "='" + foreign + "'/></rdf:RDF>");
            packet.set({foreign, "p"}, XmpValue::of("1"));
            const auto again = XmpPacket::from(packet.bytes());
            QVERIFY2(again, again ? "" : again.error().c_str());
            QCOMPARE(again->value({foreign, "p"}).value_or(XmpValue{}), XmpValue::of("1"));
            QVERIFY(packet.bytes().find("xmlns:" + prefix) != std::string::npos);
        }
    }

    void a_removed_property_is_gone_from_every_description() {
        XmpPacket packet = read(
            rdf("<rdf:Description f:p='1'/><rdf:Description><f:p>2</f:p><f:q>3</f:q></rdf:Description>"));
        packet.remove({foreign, "p"});
        const XmpPacket again = read(packet.bytes());
        QVERIFY(!again.value({foreign, "p"}));
        QVERIFY(again.value({foreign, "q"}).has_value());
    }

    void utf16_becomes_utf8() {
        const std::u16string text =
            u"<?xml version='1.0' encoding='UTF-16'?><rdf:RDF "
            u"xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' xmlns:f='http://example.org/foreign/'>"
            u"<rdf:Description f:p='\u00fc\U0001F469'/></rdf:RDF>";
        for (const bool big : {true, false}) {
            const XmpPacket packet = read(utf16(text, big));
            QCOMPARE(packet.value({foreign, "p"})->text, std::string("ü👩"));
            const std::string bytes = packet.bytes();
            QVERIFY(bytes.find("encoding=\"UTF-8\"") != std::string::npos);
            QCOMPARE(read(bytes).value({foreign, "p"})->text, std::string("ü👩"));
        }
    }

    void what_is_no_xmp_is_refused_with_words() {
        for (const std::string& text :
             {std::string(), std::string("no XML"), std::string("<a/>"), rdf("<rdf:Description>"),
              rdf("<rdf:Description f:p='\xFC'/>"), std::string("<rdf:RDF/>"),
              std::string(XmpPacket::most_bytes + 1, ' ')}) {
            const auto packet = XmpPacket::from(text);
            QVERIFY2(!packet.ok(), text.substr(0, 100).c_str());
            QVERIFY(packet.error().ends_with('.'));
        }
    }
};

} // namespace xmp_packet_test

TP_TEST(xmp_packet_test, XmpPacketTest, event_loop)
#include "xmp_packet_test.moc"
