<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>Device</name>
    <message>
        <source>%1 %  heat %2 %</source>
        <translation>%%1  ısı %%2</translation>
    </message>
    <message>
        <source>%1 %, at most %2 %</source>
        <translation>%%1, en çok %%2</translation>
    </message>
    <message>
        <source>%1 Hz, expected %2 Hz</source>
        <translation>%1 Hz, beklenen %2 Hz</translation>
    </message>
    <message>
        <source>%1 N off, at most %2 N</source>
        <translation>%1 N sapma, en çok %2 N</translation>
    </message>
    <message>
        <source>%1 counts at most while the stylus is held, expected %2</source>
        <translation>kalem tutulurken en çok %1 sayım, beklenen %2</translation>
    </message>
    <message>
        <source>%1 is no number of newtons.</source>
        <translation>%1 newton cinsinden bir sayı değil.</translation>
    </message>
    <message>
        <source>%1 mm in a second without a force</source>
        <translation>kuvvet yokken bir saniyede %1 mm</translation>
    </message>
    <message>
        <source>%1 moved by %2 counts while it was read; hold it still and try again.</source>
        <translation>Okunurken %1 eklemi %2 sayım oynadı; kıpırdatmadan tutup yeniden deneyin.</translation>
    </message>
    <message>
        <source>%1 ms median, %2 ms p99, less than %3 ms</source>
        <translation>ortanca %1 ms, %99 için %2 ms, %3 ms altında olmalı</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 içinde %1</translation>
    </message>
    <message>
        <source>%1 reads %2 of 0 to 1023, the end of its scale; check its wires and its magnet.</source>
        <translation>%1 eklemi 0–1023 aralığında %2 okuyor, ölçeğin ucu; kablolarını ve mıknatısını denetleyin.</translation>
    </message>
    <message>
        <source>%1: %2 counts between its stops, expected %3 or more; is its sensor turned by it?</source>
        <translation>%1: durdurucuları arasında %2 sayım var, beklenen en az %3; algılayıcısını eklem mi döndürüyor?</translation>
    </message>
    <message>
        <source>%1: home does not lie between its stops; was the right joint moved?</source>
        <translation>%1: başlangıç duruşu durdurucuların arasında değil; doğru eklem mi hareket ettirildi?</translation>
    </message>
    <message>
        <source>%1: home lies %2 degrees off the line through its stops, expected %3 at most; was each pose reached, and is its magnet centred?</source>
        <translation>%1: başlangıç duruşu durdurucular arasındaki doğrudan %2 derece sapıyor, beklenen en çok %3; her duruşa ulaşıldı mı, mıknatıs ortalı mı?</translation>
    </message>
    <message>
        <source>%1° off home at most</source>
        <translation>Başlangıçtan en çok %1° sapma</translation>
    </message>
    <message>
        <source>, not permitted</source>
        <translation>, izin yok</translation>
    </message>
    <message>
        <source>99 % within</source>
        <translation>%99 içinde</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Geri</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Başla</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Yeniden başla</translation>
    </message>
    <message>
        <source>Bring the arm home once more to see how far off it is now.</source>
        <translation>Şimdi ne kadar saptığını görmek için kolu bir kez daha başlangıç duruşuna getirin.</translation>
    </message>
    <message>
        <source>CALIBRATION</source>
        <translation>KALİBRASYON</translation>
    </message>
    <message>
        <source>CHECKS</source>
        <translation>DENETİMLER</translation>
    </message>
    <message>
        <source>Cable out</source>
        <translation>Kablo çıktı</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrasyon</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Vazgeç</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Denetim</translation>
    </message>
    <message>
        <source>Choose a device above and connect. The simulated one is always there.</source>
        <translation>Yukarıdan bir aygıt seçip bağlanın. Benzetim aygıtı her zaman vardır.</translation>
    </message>
    <message>
        <source>Clear the fault</source>
        <translation>Arızayı sil</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Bağlan</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Bağlanıyor…</translation>
    </message>
    <message>
        <source>Could not be saved: %1</source>
        <translation>Kaydedilemedi: %1</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Bozuk</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Koyu</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Aygıt</translation>
    </message>
    <message>
        <source>Device – Palpate</source>
        <translation>Aygıt – Palpate</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Bağlantıyı kes</translation>
    </message>
    <message>
        <source>FORCES</source>
        <translation>KUVVETLER</translation>
    </message>
    <message>
        <source>Feel a spring here</source>
        <translation>Burada yay hisset</translation>
    </message>
    <message>
        <source>Firmware's code behind a pseudo terminal</source>
        <translation>Sözde uçbirim ardında aygıt yazılımı</translation>
    </message>
    <message>
        <source>Force asked for</source>
        <translation>İstenen kuvvet</translation>
    </message>
    <message>
        <source>Force check: %1</source>
        <translation>Kuvvet denetimi: %1</translation>
    </message>
    <message>
        <source>Force given</source>
        <translation>Verilen kuvvet</translation>
    </message>
    <message>
        <source>Force the motors give</source>
        <translation>Motorların verdiği kuvvet</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kuvvetler</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Gitti</translation>
    </message>
    <message>
        <source>Greeting</source>
        <translation>Tanışıyor</translation>
    </message>
    <message>
        <source>Guided calibration</source>
        <translation>Adım adım kalibrasyon</translation>
    </message>
    <message>
        <source>Hold it at home with the scale, against the push, and take over what the scale reads (1 N is 102 g).</source>
        <translation>Başlangıç duruşunda itmeye karşı teraziyle tutun ve terazinin gösterdiğini aktarın (1 N, 102 g eder).</translation>
    </message>
    <message>
        <source>Hold still…</source>
        <translation>Kıpırdatmayın…</translation>
    </message>
    <message>
        <source>Hold the stylus in the middle of its reach. The motors push it gently, each way in turn; then this computer falls silent on purpose, and they have to stop.</source>
        <translation>Kalemi erişiminin ortasında tutun. Motorlar onu sırayla her yöne hafifçe iter; sonra bu bilgisayar bilerek susar, motorların durması gerekir.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Başlangıç</translation>
    </message>
    <message>
        <source>Home pose</source>
        <translation>Başlangıç duruşu</translation>
    </message>
    <message>
        <source>Hook a spring scale to the stylus at home. The motors come on and push this way, weakly and then more strongly. Without a scale, leave this out.</source>
        <translation>Başlangıç duruşunda kaleme bir yaylı terazi takın. Motorlar açılır ve bu yöne önce hafif, sonra daha güçlü iter. Teraziniz yoksa bunu atlayın.</translation>
    </message>
    <message>
        <source>How long commands took there and back</source>
        <translation>Komutların gidiş dönüş süresi</translation>
    </message>
    <message>
        <source>Is it sound?</source>
        <translation>Sağlam mı?</translation>
    </message>
    <message>
        <source>It cannot be connected to: %1.</source>
        <translation>Bağlanılamıyor: %1.</translation>
    </message>
    <message>
        <source>It failed a check: do not let it push anyone</source>
        <translation>Bir denetimden geçemedi: kimseyi itmesine izin vermeyin</translation>
    </message>
    <message>
        <source>It is sound</source>
        <translation>Sağlam</translation>
    </message>
    <message>
        <source>It pushes %1 with %2</source>
        <translation>%2 ile %1 itiyor</translation>
    </message>
    <message>
        <source>JOINTS</source>
        <translation>EKLEMLER</translation>
    </message>
    <message>
        <source>Jitter, 99 %</source>
        <translation>Titreme, %99</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>BAĞLANTI</translation>
    </message>
    <message>
        <source>Late ticks here</source>
        <translation>Geciken adımlar</translation>
    </message>
    <message>
        <source>Leave out the force check</source>
        <translation>Kuvvet denetimini atla</translation>
    </message>
    <message>
        <source>Leave the motors as they were</source>
        <translation>Motorları eskisi gibi bırak</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Açık</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>Aygıtları yeniden ara</translation>
    </message>
    <message>
        <source>Check that the residuals are small, then write it to the device. It is read back and compared.</source>
        <translation>Artıkların küçük olduğunu denetleyin, sonra aygıta yazın. Geri okunup karşılaştırılır.</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Kayıp</translation>
    </message>
    <message>
        <source>Lower stop: %1</source>
        <translation>Alt durdurucu: %1</translation>
    </message>
    <message>
        <source>Measure at home</source>
        <translation>Başlangıçta ölç</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>İzleme</translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation>Motorlar açık</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Bağlı değil</translation>
    </message>
    <message>
        <source>Only %1 readings came in half a second: check the cable first.</source>
        <translation>Yarım saniyede yalnız %1 okuma geldi: önce kabloyu denetleyin.</translation>
    </message>
    <message>
        <source>Pose %1 of %2: </source>
        <translation>Duruş %1 / %2: </translation>
    </message>
    <message>
        <source>Push</source>
        <translation>İt</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Aralıklar</translation>
    </message>
    <message>
        <source>Report rate</source>
        <translation>Rapor hızı</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Raporlar</translation>
    </message>
    <message>
        <source>Round trip, median</source>
        <translation>Gidiş dönüş, ortanca</translation>
    </message>
    <message>
        <source>SELF-TEST</source>
        <translation>ÖZ SINAMA</translation>
    </message>
    <message>
        <source>STATE</source>
        <translation>DURUM</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Raporu kaydet</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Raporu kaydet…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Kaydedildi: %1</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Öz sınama</translation>
    </message>
    <message>
        <source>Seven poses tell what the sensors' counts mean, three pushes against a spring scale tell what the motors give. The motors stay off until the pushes. It takes five minutes.</source>
        <translation>Yedi duruş algılayıcı sayımlarının ne anlama geldiğini, yaylı teraziye karşı üç itme motorların ne verdiğini gösterir. Motorlar itmelere dek kapalı kalır. Beş dakika sürer.</translation>
    </message>
    <message>
        <source>Simulated arm, moved by the mouse</source>
        <translation>Benzetim kolu, fareyle hareket eder</translation>
    </message>
    <message>
        <source>Something went wrong that should not: %1.</source>
        <translation>Olmaması gereken bir şey oldu: %1.</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Sınamayı başlat</translation>
    </message>
    <message>
        <source>Stop button</source>
        <translation>Durdurma</translation>
    </message>
    <message>
        <source>Straight ahead, the upper link 30° above level, the forearm at a right angle to it, the stylus in line with the forearm. A set square of 30° holds it so.</source>
        <translation>Tam karşıya, üst kol yatayın 30° üstünde, ön kol ona dik, kalem ön kolla aynı doğrultuda. 30° gönye onu böyle tutar.</translation>
    </message>
    <message>
        <source>TIP AND MOTORS</source>
        <translation>UÇ VE MOTORLAR</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Aktar</translation>
    </message>
    <message>
        <source>Take this pose</source>
        <translation>Bu duruşu al</translation>
    </message>
    <message>
        <source>Testing…</source>
        <translation>Sınanıyor…</translation>
    </message>
    <message>
        <source>Text (*.txt);;JSON (*.json)</source>
        <translation>Metin (*.txt);;JSON (*.json)</translation>
    </message>
    <message>
        <source>The %1 motor gives %2 times the torque expected, %3 to %4 can be believed; check its drive, its supply and what was read.</source>
        <translation>%1 motoru beklenen torkun %2 katını veriyor, inanılır olan %3 ile %4 arası; tahrikini, beslemesini ve okunanı denetleyin.</translation>
    </message>
    <message>
        <source>The %1 motor pulls where it should push: swap its two wires, then try again.</source>
        <translation>%1 motoru itmesi gereken yerde çekiyor: iki kablosunu değiştirip yeniden deneyin.</translation>
    </message>
    <message>
        <source>The device is gone: its cable is out, or it has fallen silent. Plug it in and connect again.</source>
        <translation>Aygıt gitti: kablosu çıkmış ya da susmuş. Takıp yeniden bağlanın.</translation>
    </message>
    <message>
        <source>The device keeps this calibration. Measure again, or begin again.</source>
        <translation>Aygıt bu kalibrasyonu saklıyor. Yeniden ölçün ya da baştan başlayın.</translation>
    </message>
    <message>
        <source>The device stored something else than was written: %1.</source>
        <translation>Aygıt yazılandan başka bir şey saklamış: %1.</translation>
    </message>
    <message>
        <source>The motors stay off: %1.</source>
        <translation>Motorlar kapalı kalıyor: %1.</translation>
    </message>
    <message>
        <source>The motors' true torques</source>
        <translation>Motorların gerçek torkları</translation>
    </message>
    <message>
        <source>The pulls do not tell the motors apart; the arm has to be at home.</source>
        <translation>İtmeler motorları birbirinden ayırmıyor; kol başlangıç duruşunda olmalı.</translation>
    </message>
    <message>
        <source>The scale reads</source>
        <translation>Terazinin gösterdiği</translation>
    </message>
    <message>
        <source>This is what came out</source>
        <translation>Sonuç bu</translation>
    </message>
    <message>
        <source>In multiples of the values before. Write them, or leave the motors as they were.</source>
        <translation>Önceki değerlerin katı olarak. Yazın ya da motorları eskisi gibi bırakın.</translation>
    </message>
    <message>
        <source>Tip (right, away, up)</source>
        <translation>Uç (sağ, ileri, yukarı)</translation>
    </message>
    <message>
        <source>Turn this joint until it meets its stop and keep it there. The others stand about as the thin arm in the picture.</source>
        <translation>Bu eklemi durdurucusuna dayanana dek çevirin ve orada tutun. Ötekiler aşağı yukarı resimdeki ince kol gibi durur.</translation>
    </message>
    <message>
        <source>Upper stop: %1</source>
        <translation>Üst durdurucu: %1</translation>
    </message>
    <message>
        <source>WHAT CAME OUT</source>
        <translation>SONUÇ</translation>
    </message>
    <message>
        <source>WHAT CAN HAPPEN (SIMULATED)</source>
        <translation>NELER OLABİLİR (BENZETİM)</translation>
    </message>
    <message>
        <source>Wire off</source>
        <translation>Kablo kopuk</translation>
    </message>
    <message>
        <source>With motors</source>
        <translation>Motorlarla</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Yazma</translation>
    </message>
    <message>
        <source>Write to the device</source>
        <translation>Aygıta yaz</translation>
    </message>
    <message>
        <source>Written and read back</source>
        <translation>Yazıldı ve geri okundu</translation>
    </message>
    <message>
        <source>after %1 ms: %2</source>
        <translation>%1 ms sonra: %2</translation>
    </message>
    <message>
        <source>arm carried</source>
        <translation>kol taşınıyor</translation>
    </message>
    <message>
        <source>arm within its range</source>
        <translation>kol aralığında</translation>
    </message>
    <message>
        <source>away</source>
        <translation>ileri</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>sizden öteye</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>kalibrasyon</translation>
    </message>
    <message>
        <source>damaged frames</source>
        <translation>bozuk çerçeveler</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>yükseliş</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>ön kol</translation>
    </message>
    <message>
        <source>gimbal pitch</source>
        <translation>askı eğilme</translation>
    </message>
    <message>
        <source>gimbal roll</source>
        <translation>askı dönme</translation>
    </message>
    <message>
        <source>gimbal yaw</source>
        <translation>askı sapma</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>boşta</translation>
    </message>
    <message>
        <source>in this process</source>
        <translation>bu süreçte</translation>
    </message>
    <message>
        <source>joints at %1 degrees</source>
        <translation>eklemler %1 derecede</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>son %1 s</translation>
    </message>
    <message>
        <source>lost reports</source>
        <translation>kayıp raporlar</translation>
    </message>
    <message>
        <source>motors off</source>
        <translation>motorlar kapalı</translation>
    </message>
    <message>
        <source>motors on</source>
        <translation>motorlar açık</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>kayma</translation>
    </message>
    <message>
        <source>none that can be used: calibrate the device</source>
        <translation>kullanılabilir olan yok: aygıtı kalibre edin</translation>
    </message>
    <message>
        <source>off home</source>
        <translation>fark</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>eğilme</translation>
    </message>
    <message>
        <source>push away %1 N</source>
        <translation>ileri itme %1 N</translation>
    </message>
    <message>
        <source>push right %1 N</source>
        <translation>sağa itme %1 N</translation>
    </message>
    <message>
        <source>push up %1 N</source>
        <translation>yukarı itme %1 N</translation>
    </message>
    <message>
        <source>report rate</source>
        <translation>rapor hızı</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>artık</translation>
    </message>
    <message>
        <source>right</source>
        <translation>sağ</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>dönme</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>gidiş dönüş</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>çalışıyor</translation>
    </message>
    <message>
        <source>sensor noise</source>
        <translation>algılayıcı gürültüsü</translation>
    </message>
    <message>
        <source>silence stops the motors</source>
        <translation>sessizlik motorları durduruyor</translation>
    </message>
    <message>
        <source>stylus yaw</source>
        <translation>kalem: sapma</translation>
    </message>
    <message>
        <source>the fault clears</source>
        <translation>arıza siliniyor</translation>
    </message>
    <message>
        <source>the firmware's code behind %1</source>
        <translation>%1 arkasında aygıt yazılımının kodu</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>sağa</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>tork</translation>
    </message>
    <message>
        <source>up</source>
        <translation>yukarı</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>yukarı doğru</translation>
    </message>
    <message>
        <source>valid, in the device's EEPROM</source>
        <translation>geçerli, aygıtın EEPROM'unda</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>sapma</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>sıfır</translation>
    </message>
</context>
</TS>
